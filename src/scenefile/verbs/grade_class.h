#pragma once
// The pictures that a class handed in against the references, from folders to a gradebook.

#include "scenefile/base/result.h"
#include "scenefile/grade/gradebook.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/grade_files.h"

#include <functional>
#include <string>

namespace scenefile {

struct GradeRequest {
  std::string handed_in;   ///< a folder with one for each student, or with the pictures of one
  std::string references;  ///< a folder with the right pictures
  std::string scenes;      ///< a folder with what they show; empty: look in `references`
  /// Without thresholds what is wrong decides: a known mistake fails at any PSNR, edges and
  /// rounding alone pass.
  CompareSettings compare;
  bool thumbnails = false;    ///< PictureResult::png of those that differ
  std::vector<NamePair> map;  ///< names that follow no layout (grade_files.h)
  /// Told of each student as soon as all pictures are graded: the student, counted from 1, and how
  /// many pictures the class has. May take PictureResult::png away; an error stops all.
  std::function<Result<void>(StudentResult& student, std::size_t number, std::size_t all)> graded;
};

/// The pictures of a larger class are smaller, and better kept in files than in memory.
inline constexpr std::size_t many_pictures = 200;

/// Loads a scene that references show, and says what is wrong with it to whom it concerns.
using LoadShownScene = std::function<LoadedScene(const std::string& path)>;

/// Grades all students, in the order of their names. Pictures are matched with references by name
/// (grade_files.h). Fails where a folder or a reference cannot be read, where no picture has the
/// name of a reference, and where `go_on`, told the share that is done now and then, says to stop
/// (ErrorKind::cancelled). `entering` is told what begins, as in LoadSettings.
Result<Gradebook> grade_class(const GradeRequest& request, const LoadShownScene& load_scene,
                              const std::function<bool(double done)>& go_on = {},
                              const std::function<void(const char* phase)>& entering = {});

/// The document of `grade --json`.
std::string gradebook_json(const Gradebook& book);

}  // namespace scenefile
