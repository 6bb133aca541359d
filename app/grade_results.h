#pragma once
// The output of grade, and of merge for parts of a class.

#include "app/command.h"
#include "app/output.h"
#include "scenefile/grade/gradebook.h"

#include <span>
#include <string_view>

namespace scenefile::app {

/// Detects before the work starts that results cannot be written, or would replace one another or
/// one of the `inputs`.
ExitCode check_result_places(const Options& options, std::span<const NamedFile> inputs);

/// Writes all files and prints the results: the files of the class, and with --pages a page for
/// each student. In large classes, the pictures are files next to the report. If a file cannot be
/// written, or the program is interrupted, no new file remains. `holder`: what contains the
/// students, such as a folder, for messages.
ExitCode write_results(const Options& options, Gradebook book, std::string_view holder,
                       Context& context);

}  // namespace scenefile::app
