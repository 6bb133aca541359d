#include "app/command.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/limits.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/grade_class.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace scenefile::app {

namespace {

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

ExitCode check_places(const Options& options) {
  for (const std::string& target :
       {options.report, options.junit, options.csv, options.gradescope}) {
    if (const Result<void> writable = target.empty() ? Result<void>() : check_writable(target);
        !writable) {
      say_error(writable.error().text);
      return ExitCode::environment;
    }
  }
  return ExitCode::fine;
}

Result<std::vector<NamePair>> load_map(const Options& options) {
  if (options.name_map.empty()) {
    return std::vector<NamePair>();
  }
  const Result<std::string> text = read_file(options.name_map, Limits{}.file_bytes);
  if (!text) {
    return text.error();
  }
  std::string wrong;
  std::vector<NamePair> map = read_name_map(*text, wrong);
  if (!wrong.empty()) {
    return Error{fmt::format("{}: {}", quoted(options.name_map, 400), wrong), ErrorKind::input};
  }
  return map;
}

// The files for each student: a page, and for large classes the pictures next to the report.
class HandOut {
 public:
  explicit HandOut(const Options& options) : options_(options) {}

  Result<void> operator()(StudentResult& student, std::size_t number, std::size_t all) {
    if (!options_.pages.empty()) {
      const Result<void> written =
          write(options_.pages, page_name(student.name) + ".html", student_html(student, title));
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
          write((report.parent_path() / folder).string(), name, picture.png);
      if (!written) {
        return written;
      }
      picture.png.clear();
      picture.png_file = folder + "/" + name;
    }
    return {};
  }

  static constexpr std::string_view title = "Ray tracer grades";

 private:
  static Result<void> write(const std::string& folder, const std::string& name,
                            const std::string& bytes) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
      return Error{
          fmt::format("cannot create the folder {}: {}", quoted(folder, 400), error.message())};
    }
    return write_file((std::filesystem::path(folder) / name).string(), bytes);
  }

  // A unique file name for each student.
  std::string page_name(const std::string& student) {
    std::string name;
    for (const char c : student) {
      const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                         std::string_view("._-").find(c) != std::string_view::npos;
      name += plain ? c : '_';
    }
    const int before = pages_[name]++;
    return before == 0 ? name : fmt::format("{}-{}", name, before + 1);
  }

  const Options& options_;
  std::map<std::string, int> pages_;
};

}  // namespace

ExitCode run_grade(const Options& options, Context& context) {
  if (const ExitCode status = check_places(options); status != ExitCode::fine) {
    return status;
  }
  Result<std::vector<NamePair>> map = load_map(options);
  if (!map) {
    say_error(map.error().text);
    return exit_code(map.error().kind);
  }
  HandOut hand_out(options);
  const GradeRequest request{.handed_in = options.arguments.front(),
                             .references = options.references,
                             .scenes = options.scenes,
                             .compare = compare_settings(options),
                             .thumbnails = !options.report.empty() || !options.pages.empty(),
                             .map = *std::move(map),
                             .graded = std::ref(hand_out)};
  const auto load_scene = [&](const std::string& path) {
    return load_scene_of_pictures(path, options, context);
  };
  std::optional<ProgressBar> bar(!options.quiet && !options.json && wants_progress());
  const auto go_on = [&](double done) {
    bar->update(done);
    return true;
  };
  const Result<Gradebook> graded =
      grade_class(request, load_scene, go_on, [&](const char* phase) { context.phase = phase; });
  bar.reset();
  if (!graded) {
    say_error(graded.error().text);
    return exit_code(graded.error().kind);
  }
  const Gradebook& book = *graded;
  if (!options.gradescope.empty() && book.students.size() != 1) {
    say_error(fmt::format("--gradescope is for one student, and {} holds {}",
                          quoted(options.arguments.front(), 400), book.students.size()));
    return ExitCode::usage;
  }
  ExitCode status = book.all_passed() ? ExitCode::fine : ExitCode::findings;
  // Everything is prepared before files are written, so that nothing can fail afterwards.
  context.phase = "making the report";
  const std::string page =
      options.report.empty() ? std::string() : gradebook_html(book, HandOut::title);
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
