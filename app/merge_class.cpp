#include "app/grade_results.h"
#include "app/load.h"
#include "app/merge.h"
#include "app/output.h"
#include "app/part_files.h"

#include <utility>
#include <vector>

namespace scenefile::app {

ExitCode merge_class(const Options& options, const SortedParts& set,
                     std::span<const std::string> paths, Context& context) {
  context.phase = "reading the parts";
  std::vector<NamedFile> inputs;
  for (const std::string& path : paths) {
    inputs.push_back({"part", path});
  }
  if (const ExitCode status = check_result_places(options, inputs); status != ExitCode::fine) {
    return status;
  }
  Gradebook book;
  for (const std::size_t file : set.files) {
    Result<GradePart> part = read_grade_part(paths[file]);
    if (!part) {
      say_error(part.error().text);
      return exit_code(part.error().kind);
    }
    if (!part->damage.empty()) {
      say_error(part->damage);
      return ExitCode::findings;
    }
    for (StudentResult& student : part->students) {
      for (PictureResult& picture : student.pictures) {
        if (options.report.empty() && options.pages.empty()) {
          picture.png = {};
        }
      }
      book.students.push_back(std::move(student));
    }
  }
  return write_results(options, std::move(book), "the class", context);
}

}  // namespace scenefile::app
