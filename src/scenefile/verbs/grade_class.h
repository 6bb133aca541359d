#pragma once
// Grades the pictures that a class submitted: from folders to a gradebook.

#include "scenefile/base/result.h"
#include "scenefile/gradebook/gradebook.h"
#include "scenefile/io/used_files.h"
#include "scenefile/verbs/compare_paths.h"
#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/grade_files.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenefile {

struct GradeRequest {
  std::string handed_in;   ///< one folder per student, or the pictures of one student
  std::string references;  ///< a folder with the correct pictures
  std::string scenes;      ///< a folder with their scenes; empty: look in `references`
  /// Without thresholds, the kind of difference decides: pictures with known mistakes fail at any
  /// PSNR, pictures that only differ in ways that are not mistakes pass, others with 40 dB or more.
  CompareSettings compare;
  std::string layer{};          ///< of EXR files with layers
  bool thumbnails = false;      ///< create PictureResult::png
  std::vector<NamePair> map{};  ///< pairs of names that the rules of grade_files.h cannot match
  /// Options of mode path: the pictures are path-traced, and the references are configurations of
  /// the course (grade_paths.h); thresholds are not used.
  std::optional<RenderOptions> path = std::nullopt;
  double seconds = truth_seconds;  ///< mode path: processor time for each truth
  bool one_student = false;        ///< whatever `handed_in` looks like
  /// Folders for results. In `handed_in` they are no students, like `references` and `scenes`.
  std::vector<std::string> results{};
};

/// Classes with more pictures get smaller thumbnails, which callers should write to files instead
/// of embedding them in the report.
inline constexpr std::size_t many_pictures = 200;

/// Loads the scene of a reference, and reports its findings.
using LoadShownScene = std::function<LoadedScene(const std::string& path)>;

/// A class whose references are loaded and whose pictures are found, ready to be graded, one
/// student at a time.
class ClassGrader {
 public:
  /// Fails like grade_class(). `request` must outlive the result.
  static Result<ClassGrader> open(const GradeRequest& request, const LoadShownScene& load_scene,
                                  const std::function<void(const char* phase)>& entering = {});
  ClassGrader(ClassGrader&& other) noexcept;
  ClassGrader& operator=(ClassGrader&&) = delete;
  ~ClassGrader();

  std::size_t students() const;
  const std::string& student(std::size_t index) const;  ///< the name, StudentResult::name
  /// The number of pictures expected from the whole class.
  std::size_t pictures() const;

  /// What the results of a student depend on, except for the options: words of a key (io/item.h).
  std::string key_of(std::size_t student);

  /// The results do not depend on which other students are graded. Fails only if `go_on` returns
  /// false (ErrorKind::cancelled).
  Result<StudentResult> grade(std::size_t student,
                              const std::function<bool(double done)>& go_on = {});

  /// The files of the references and of the class, used or not: no output may replace one of them.
  const std::vector<UsedFile>& inputs() const;

  /// Decisions that the grader may not expect, such as which of two pictures was graded: a sentence
  /// each, without a period at the end.
  const std::vector<std::string>& notes() const;

  /// The class without results: its name, and the files that are ignored.
  Gradebook empty_book() const;

 private:
  struct State;
  explicit ClassGrader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Grades all students, in the order of their names. Pictures are matched with references by name
/// (grade_files.h). Fails if a folder or a reference cannot be read, if a reference was
/// handed in, if no picture has the name of a reference, and if `go_on`, which is called
/// occasionally with the finished fraction, returns false (ErrorKind::cancelled). `entering` is
/// called at the start of each phase, as in LoadSettings.
Result<Gradebook> grade_class(const GradeRequest& request, const LoadShownScene& load_scene,
                              const std::function<bool(double done)>& go_on = {},
                              const std::function<void(const char* phase)>& entering = {});

/// The document of `grade --json`.
std::string gradebook_json(const Gradebook& book);

}  // namespace scenefile
