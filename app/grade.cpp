#include "app/command.h"
#include "app/load.h"
#include "app/load_picture.h"
#include "app/output.h"
#include "app/progress.h"
#include "scenefile/base/text.h"
#include "scenefile/io/file.h"
#include "scenefile/verbs/grade_class.h"

#include <optional>

namespace scenefile::app {

namespace {

// Lines may hold names of files.
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
  for (const std::string& target : {options.report, options.junit}) {
    if (const Result<void> writable = target.empty() ? Result<void>() : check_writable(target);
        !writable) {
      say_error(writable.error().text);
      return ExitCode::environment;
    }
  }
  return ExitCode::fine;
}

}  // namespace

ExitCode run_grade(const Options& options, Context& context) {
  if (const ExitCode status = check_places(options); status != ExitCode::fine) {
    return status;
  }
  const GradeRequest request{.handed_in = options.arguments.front(),
                             .references = options.references,
                             .scenes = options.scenes,
                             .compare = compare_settings(options),
                             .thumbnails = !options.report.empty()};
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
  ExitCode status = book.all_passed() ? ExitCode::fine : ExitCode::findings;
  // All is ready before something is written, so that nothing can fail afterwards.
  context.phase = "making the report";
  const std::string page =
      options.report.empty() ? std::string() : gradebook_html(book, "Ray tracer grades");
  const std::string junit = options.junit.empty() ? std::string() : gradebook_junit(book);
  const std::string text = options.json    ? gradebook_json(book)
                           : options.quiet ? std::string()
                                           : safe_lines(gradebook_text(book));
  context.phase = "writing the report";
  status = worse(status, write_text(options.report, page));
  status = worse(status, write_text(options.junit, junit));
  return text.empty() ? status : worse(status, answer(text));
}

}  // namespace scenefile::app
