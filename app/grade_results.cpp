#include "app/grade_results.h"

#include "app/output.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/grade_class.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <filesystem>

namespace scenefile::app {

namespace {

constexpr std::string_view title = "Ray tracer grades";

// Lines may contain file names.
std::string safe_lines(const std::string& text) {
  std::string result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    result += escaped(text.substr(start, end - start), 4096) + "\n";
    start = end == std::string::npos ? text.size() : end + 1;
  }
  return result;
}

ExitCode write_text(const std::string& path, const std::string& text) {
  if (path.empty()) {
    return ExitCode::fine;
  }
  const Result<void> written = write_file(path, text);
  if (!written) {
    say_error(written.error().text);
  }
  return written ? ExitCode::fine : ExitCode::environment;
}

Result<void> write_into(const std::string& folder, const std::string& name,
                        const std::string& bytes) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return Error{
        fmt::format("cannot make the folder {}: {}", quoted(folder, 400), error.message())};
  }
  return write_file((std::filesystem::path(folder) / name).string(), bytes);
}

}  // namespace

ExitCode check_result_places(const Options& options, std::span<const NamedFile> inputs) {
  const std::array<NamedFile, 5> outputs{{{"part", options.output},
                                          {"report", options.report},
                                          {"JUnit file", options.junit},
                                          {"CSV table", options.csv},
                                          {"Gradescope file", options.gradescope}}};
  return check_outputs(inputs, outputs);
}

Result<void> StudentFiles::operator()(StudentResult& student, std::size_t number, std::size_t all) {
  if (!options_.pages.empty()) {
    const Result<void> written =
        write_into(options_.pages, page_name(student.name) + ".html", student_html(student, title));
    if (!written) {
      return written;
    }
  }
  if (options_.report.empty() || all <= many_pictures) {
    return {};
  }
  const std::filesystem::path report(options_.report);
  const std::string folder = report.stem().string() + "-pictures";
  for (std::size_t p = 0; p < student.pictures.size(); ++p) {
    PictureResult& picture = student.pictures[p];
    if (picture.png.empty()) {
      continue;
    }
    const std::string name = fmt::format("{}-{}.png", number, p + 1);
    const Result<void> written =
        write_into((report.parent_path() / folder).string(), name, picture.png);
    if (!written) {
      return written;
    }
    picture.png.clear();
    picture.png_file = folder + "/" + name;
  }
  return {};
}

// A unique file name for each student.
std::string StudentFiles::page_name(const std::string& student) {
  std::string name;
  for (const char c : student) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                       std::string_view("._-").find(c) != std::string_view::npos;
    name += plain ? c : '_';
  }
  const int before = pages_[name]++;
  return before == 0 ? name : fmt::format("{}-{}", name, before + 1);
}

ExitCode write_results(const Options& options, const Gradebook& book, std::string_view holder,
                       Context& context) {
  if (!options.gradescope.empty() && book.students.size() != 1) {
    say_error(fmt::format("--gradescope is for one student, and {} has {}", holder,
                          book.students.size()));
    return ExitCode::usage;
  }
  ExitCode status = book.all_passed() ? ExitCode::fine : ExitCode::findings;
  // Everything is prepared before files are written, so that nothing can fail afterwards.
  context.phase = "making the report";
  const std::string page = options.report.empty() ? std::string() : gradebook_html(book, title);
  const std::string junit = options.junit.empty() ? std::string() : gradebook_junit(book);
  const std::string csv = options.csv.empty() ? std::string() : gradebook_csv(book);
  const std::string scope =
      options.gradescope.empty() ? std::string() : gradescope_json(book.students.front());
  const std::string text = options.json    ? gradebook_json(book)
                           : options.quiet ? std::string()
                                           : safe_lines(gradebook_text(book));
  context.phase = "writing the report";
  status = worse(status, write_text(options.report, page));
  status = worse(status, write_text(options.junit, junit));
  status = worse(status, write_text(options.csv, csv));
  status = worse(status, write_text(options.gradescope, scope));
  return text.empty() ? status : worse(status, answer(text));
}

}  // namespace scenefile::app
