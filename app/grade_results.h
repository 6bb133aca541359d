#pragma once
// The output of grade, and of merge for parts of a class.

#include "app/command.h"
#include "app/outputs.h"
#include "scenefile/base/result.h"
#include "scenefile/grade/gradebook.h"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// Detects before the work starts that results cannot be written, or would replace one another or
/// one of the `inputs`.
ExitCode check_result_places(const Options& options, std::span<const NamedFile> inputs);

/// Writes the files of each student: a page and, for large classes, the pictures next to the
/// report.
class StudentFiles {
 public:
  /// `options` must outlive this.
  explicit StudentFiles(const Options& options) : options_(options) {}

  /// For GradeRequest::graded: all students of the class, in order.
  Result<void> operator()(StudentResult& student, std::size_t number, std::size_t all);

 private:
  std::string page_name(const std::string& student);

  const Options& options_;
  std::map<std::string, int> pages_;
};

/// Writes the files of the whole class and prints the results. `holder`: what contains the
/// students, such as a folder, for messages.
ExitCode write_results(const Options& options, const Gradebook& book, std::string_view holder,
                       Context& context);

}  // namespace scenefile::app
