#include "app/grade_results.h"
#include "app/load.h"
#include "app/merge.h"
#include "app/named_files.h"
#include "app/output.h"
#include "app/part_files.h"

#include <utility>
#include <vector>

namespace scenefile::app {

ExitCode merge_class(const Options& options, const SortedParts& set,
                     std::span<const std::string> paths, Context& context) {
  context.phase = "reading the parts";
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
    book.name = book.name.empty() ? part->book.name : book.name;
    for (StudentResult& student : part->book.students) {
      for (PictureResult& picture : student.pictures) {
        if (options.report.empty() && options.pages.empty()) {
          picture.png = {};
        }
      }
      book.students.push_back(std::move(student));
    }
    book.ignored.insert(book.ignored.end(), part->book.ignored.begin(), part->book.ignored.end());
  }
  find_identical_files(book);
  std::vector<std::string> students;
  std::size_t pictures = 0;
  for (const StudentResult& student : book.students) {
    students.push_back(student.name);
    pictures += student.pictures.size();
  }
  Outcome refused = check_named_outputs(options);
  if (refused.status == ExitCode::fine) {
    refused = claim_pages(options, students, pictures, context);
  }
  if (refused.status != ExitCode::fine) {
    say_error(refused.error);
    return refused.status;
  }
  return write_results(options, std::move(book), "the class", context);
}

}  // namespace scenefile::app
