#pragma once
// The files that the command line names. Their use follows from the words of the usage texts: OUT
// is a file to write, OUTDIR a folder for files to write, PATTERN the names of numbered files to
// write; a FILE, PICTURE, SCENE and so on is read.

#include "app/load.h"

#include <span>
#include <string>
#include <string_view>

namespace scenefile::app {

/// A file of the command line in messages: `the output a.png`, `the heat map h.png`.
UsedFile named_file(std::string_view role, const std::string& path);

/// Adds the files of all arguments and options to `files`. Returns an error (ErrorKind::usage) if
/// one to write is another of them. Commands add the files that only they know: the contents of
/// folders, assets of scenes (app/load.h does), numbered files, files next to the output.
Result<void> add_named_files(const Command& command, const Options& options, UsedFiles& files);

/// Whether the value of the option names a file or a folder.
bool names_file(const OptionRow& row);

/// Whether the options name a file to write.
bool writes_files(const Options& options);

/// Whether the files after options can be written, before the work starts
/// (ExitCode::environment).
Outcome check_named_outputs(const Options& options);

/// Creates the folder of the output, if it is missing and the scene exists. Failures are reported
/// later, by claim_outputs().
void make_output_folder(const Options& options);

/// Adds files that are read to context.files. Returns an error (ExitCode::usage) for the first that
/// an output would replace.
Outcome claim_inputs(std::span<const UsedFile> inputs, Context& context);

/// Adds outputs that the options do not name to context.files, before the work starts and after all
/// inputs are known. Returns an error for the first that would replace an input or another output
/// (ExitCode::usage), or that cannot be written (ExitCode::environment).
Outcome claim_outputs(std::span<const UsedFile> outputs, Context& context);

}  // namespace scenefile::app
