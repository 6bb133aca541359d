#include "app/grade_results.h"

#include "app/load.h"
#include "app/named_files.h"
#include "app/option_table.h"
#include "app/output.h"
#include "scenefile/base/hash.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"
#include "scenefile/io/interrupt.h"
#include "scenefile/verbs/grade_class.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace scenefile::app {

namespace {

namespace fs = std::filesystem;

// What all pages of a class have in common.
struct PageHeading {
  std::string title;
  std::string date;
};

// The date of today, or in UTC of SOURCE_DATE_EPOCH (reproducible-builds.org), if that is set.
// Without <fmt/chrono.h>, which needs locales: the WebAssembly build has none.
std::string date_of_report() {
  const auto text = [](const std::tm& day) {
    return fmt::format("{:04}-{:02}-{:02}", day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
  };
  std::tm day{};
  std::string digits;
  if (const char* const given = std::getenv("SOURCE_DATE_EPOCH")) {
    digits = given;
  }
  std::int64_t seconds = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, seconds);
  constexpr std::int64_t year_10000 = 253402300800;
  if (error == std::errc() && stop == end && seconds >= 0 && seconds < year_10000) {
    const auto time = static_cast<std::time_t>(seconds);
    return text(*::gmtime_r(&time, &day));
  }
  const std::time_t now = std::time(nullptr);
  return text(*::localtime_r(&now, &day));
}

// Writes files, and removes those that did not exist before, with their folders, unless they are
// kept.
class NewFiles {
 public:
  NewFiles() = default;
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles() {
    // Folders precede their files, and only those without other files can be removed.
    for (auto path = added_.rbegin(); path != added_.rend(); ++path) {
      std::error_code ignored;
      fs::remove(*path, ignored);
    }
  }

  Result<void> make_folder(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) {
      return {};
    }
    if (const Result<void> parent = make_folder(folder.parent_path()); !parent) {
      return parent;
    }
    if (fs::create_directory(folder, error)) {
      added_.push_back(folder);
    }
    return !error ? Result<void>()
                  : Error{fmt::format("cannot make the folder {}: {}", quoted(folder.string(), 400),
                                      error.message())};
  }

  Result<void> write(const fs::path& path, const std::string& bytes) {
    if (DeferredSignals::pending() != 0) {
      return Error{"interrupted", ErrorKind::cancelled};
    }
    std::error_code ignored;
    const bool existed = fs::exists(path, ignored);
    const Result<void> written = write_file(path.string(), bytes);
    if (written && !existed) {
      added_.push_back(path);
    }
    return written;
  }

  void keep() { added_.clear(); }

 private:
  std::vector<fs::path> added_;
};

Result<void> write_pages(const std::string& folder, const Gradebook& book,
                         const PageHeading& heading, NewFiles& files) {
  if (const Result<void> made = files.make_folder(folder); !made) {
    return made;
  }
  std::vector<std::string> students;
  for (const StudentResult& student : book.students) {
    students.push_back(student.name);
  }
  const std::vector<std::string> names = student_file_names(students);
  for (std::size_t s = 0; s < names.size(); ++s) {
    const Result<void> written =
        files.write(fs::path(folder) / (names[s] + ".html"),
                    student_html(book.students[s], heading.title, heading.date,
                                 ignored_lines(book, book.students[s].name)));
    if (!written) {
      return written;
    }
  }
  return {};
}

std::size_t count_pictures(const Gradebook& book) {
  std::size_t pictures = 0;
  for (const StudentResult& student : book.students) {
    pictures += student.pictures.size();
  }
  return pictures;
}

// A picture next to the report, relative to it; counted from 0.
std::string picture_name(const std::string& report, std::size_t student, std::size_t picture) {
  return fmt::format("{}/{}-{}.png", fs::path(pictures_folder(report)).filename().string(),
                     student + 1, picture + 1);
}

// Moves the pictures out of the report, if there are many.
Result<void> write_pictures(const std::string& report, Gradebook& book, NewFiles& files) {
  if (count_pictures(book) <= many_pictures) {
    return {};
  }
  const fs::path parent = fs::path(report).parent_path();
  for (std::size_t s = 0; s < book.students.size(); ++s) {
    std::vector<PictureResult>& of_student = book.students[s].pictures;
    for (std::size_t p = 0; p < of_student.size(); ++p) {
      PictureResult& picture = of_student[p];
      if (picture.png.empty()) {
        continue;
      }
      const std::string name = picture_name(report, s, p);
      Result<void> done = files.make_folder((parent / name).parent_path());
      done = done ? files.write(parent / name, picture.png) : done;
      if (!done) {
        return done;
      }
      picture.png.clear();
      picture.png_file = name;
    }
  }
  return {};
}

Result<void> write_all(const Options& options, Gradebook& book) {
  const DeferredSignals deferred;
  const PageHeading heading{!options.title.empty() ? options.title
                            : !book.name.empty()   ? book.name
                                                   : "Grades",
                            date_of_report()};
  NewFiles files;
  Result<void> done;
  if (!options.pages.empty()) {
    done = write_pages(options.pages, book, heading, files);
  }
  if (done && !options.report.empty()) {
    done = write_pictures(options.report, book, files);
  }
  const auto write = [&](const std::string& path, const auto& text) {
    if (done && !path.empty()) {
      done = files.write(path, text());
    }
  };
  write(options.report, [&] { return gradebook_html(book, heading.title, heading.date); });
  write(options.junit, [&] { return gradebook_junit(book); });
  write(options.csv, [&] { return gradebook_csv(book); });
  write(options.csv_students, [&] { return students_csv(book); });
  write(options.gradescope, [&] { return gradescope_json(book.students.front()); });
  if (done) {
    files.keep();
  }
  return done;
}

}  // namespace

std::vector<std::string> student_file_names(std::span<const std::string> students) {
  constexpr std::size_t max_length = 200;  // of 255 bytes
  std::vector<std::string> names;
  for (const std::string& student : students) {
    std::string name;
    for (const char c : student.substr(0, max_length)) {
      const auto byte = static_cast<unsigned char>(c);
      const bool plain = byte >= 0x80 || std::isalnum(byte) != 0 ||
                         std::string_view("._-").find(c) != std::string_view::npos;
      name += plain ? c : '_';
    }
    if (name != student) {
      Hash hash;
      hash.add(student);
      name += fmt::format("-{:08x}", static_cast<std::uint32_t>(hash.value()));
    }
    names.push_back(std::move(name));
  }
  return names;
}

std::string pictures_folder(const std::string& report) {
  const fs::path path(report);
  return report.empty() ? std::string()
                        : (path.parent_path() / (path.stem().string() + "-pictures")).string();
}

Outcome claim_pages(const Options& options, std::span<const std::string> students,
                    std::size_t pictures, Context& context) {
  Result<void> added;
  const auto add = [&](std::string_view role, const fs::path& path) {
    added = added ? context.files.write(named_file(role, path.string())) : added;
  };
  if (!options.pages.empty() && !is_folder(options.pages)) {
    add("folder of pages", options.pages);
  }
  const std::vector<std::string> names = student_file_names(students);
  for (std::size_t s = 0; s < students.size(); ++s) {
    if (!options.pages.empty()) {
      add("page of a student", fs::path(options.pages) / (names[s] + ".html"));
    }
    for (std::size_t p = 0; pictures > many_pictures && p < pictures / students.size(); ++p) {
      if (!options.report.empty()) {
        add("picture of the report",
            fs::path(options.report).parent_path() / picture_name(options.report, s, p));
      }
    }
  }
  return outcome_of(added);
}

ExitCode write_results(const Options& options, Gradebook book, Context& context) {
  const ExitCode status = book.all_passed() ? ExitCode::fine : ExitCode::findings;
  // Before the files, so that running out of memory here leaves none.
  const std::string text = options.json    ? gradebook_json(book)
                           : options.quiet ? std::string()
                                           : gradebook_text(book);
  context.phase = "writing the report";
  if (const Result<void> written = write_all(options, book); !written) {
    return fail(written.error());
  }
  // A table on standard output stays one that programs can read.
  const bool taken = std::any_of(options.given.begin(), options.given.end(), [](const auto& given) {
    return given.row->value == "OUT" && is_standard_output(given.value);
  });
  if (taken) {
    say(text);
    return status;
  }
  return text.empty() ? status : worse(status, answer(text));
}

}  // namespace scenefile::app
