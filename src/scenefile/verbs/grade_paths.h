#pragma once
// Grades path-traced pictures. Their references are configurations of the course's path tracer, of
// which the truth is drawn.

#include "scenefile/base/result.h"
#include "scenefile/gradebook/gradebook.h"
#include "scenefile/noise/judge_path.h"
#include "scenefile/verbs/grade_files.h"

#include <string>
#include <vector>

namespace scenefile {

/// A configuration, as a reference.
struct PathReference {
  FoundFile file;         ///< its path; the name and folders are those of its output
  std::string text;       ///< its contents
  std::string scene;      ///< a path
  RenderOptions options;  ///< of the picture
};

/// The configurations of the path tracer below `folder`; those of the ray tracer are skipped. Their
/// scenes are relative to the folder `scenes`, or if that is empty, to the working directory.
/// `options`: what configurations do not say. Fails if there are none, and if one has errors.
/// `notes` gets warnings, and why other files are skipped.
Result<std::vector<PathReference>> path_references(const std::string& folder,
                                                   const std::string& scenes,
                                                   const RenderOptions& options,
                                                   std::vector<std::string>& notes);

/// Sets what the verdict says about the picture: verdict, reasons, claims and notes.
void set_result(const PathVerdict& verdict, PictureResult& result);

}  // namespace scenefile
