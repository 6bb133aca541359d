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

/// Adds the pages of these students and the pictures next to the report to context.files. An error
/// if one would replace another file. `pictures`: the number of pictures of the class.
Outcome claim_pages(const Options& options, std::span<const std::string> students,
                    std::size_t pictures, Context& context);

/// Writes all files and prints the results: the files of the class, and with --pages a page for
/// each student. In large classes, the pictures are files next to the report. If a file cannot be
/// written, or the program is interrupted, no new file remains. `holder`: what contains the
/// students, such as a folder, for messages.
ExitCode write_results(const Options& options, Gradebook book, std::string_view holder,
                       Context& context);

}  // namespace scenefile::app
