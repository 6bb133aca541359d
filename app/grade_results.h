#pragma once
// The output of grade.

#include "app/load.h"
#include "scenefile/gradebook/gradebook.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile::app {

/// Names of files for these students, without extension. Each depends on the student alone: a class
/// may grow. Where characters are replaced, a hash of the name tells students apart.
std::vector<std::string> student_file_names(std::span<const std::string> students);

/// The folder of the pictures next to a report; empty if there is no report.
std::string pictures_folder(const std::string& report);

/// Adds the pages of these students and the pictures next to the report to context.files. An error
/// if one would replace another file. `pictures`: the number of pictures of the class.
Outcome claim_pages(const Options& options, std::span<const std::string> students,
                    std::size_t pictures, Context& context);

/// Writes all files and prints the results: the files of the class, and with --pages a page for
/// each student. In large classes, the pictures are files next to the report. If a file cannot be
/// written, or the program is interrupted, no new file remains.
ExitCode write_results(const Options& options, Gradebook book, Context& context);

}  // namespace scenefile::app
