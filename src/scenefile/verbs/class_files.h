#pragma once
// Finds the students of a class and their files: folders, archives, and what course systems write.

#include "scenefile/gradebook/gradebook.h"
#include "scenefile/io/archive.h"
#include "scenefile/verbs/grade_files.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct StudentFiles {
  std::string name;  ///< unique in the class
  std::vector<FoundFile> pictures;
  std::vector<IgnoredFile> ignored;
};

struct ClassFiles {
  std::vector<StudentFiles> students;  ///< by name
  std::vector<IgnoredFile> ignored;    ///< of unknown students
  std::vector<std::string> paths;  ///< of all files and archives that were handed in, not of others
  /// Why a folder that may be a class is taken for one student's; else empty.
  std::string one_student;
};

/// The students in `folder`, which may also be an archive:
/// - each folder and each archive in it, by name, and the files of course systems, which name their
///   student: Canvas (smithjohn_LATE_123_456_ball.png), Blackboard
///   (hw2_jsmith_attempt_2024-03-01-12-00-00_ball.png), Moodle (Ann
///   Lee_123_assignsubmission_file_). submission_metadata.yml names those of Gradescope's folders
///   (submission_123). Of several attempts, the last one counts.
/// - or a single one, if all its folders with pictures are those of a layout (is_layout_folder()),
///   if at least as many pictures directly in it have the name of a reference as in its folders, or
///   if `one_student` says so.
///
/// Archives are read as folders, also in folders and in archives. Junk (is_junk_name()) is skipped.
/// Everything else that is not a picture of a student, what is hidden, and what is or contains one
/// of the `other_folders`, is ignored with a reason.
ClassFiles find_class_files(const std::string& folder, const std::vector<FoundFile>& references,
                            const std::vector<std::string>& other_folders = {},
                            bool one_student = false);

/// The name of the folder, or of the archive without its ending.
std::string name_of_class(const std::string& folder);

/// What a name in the form of a course system says.
struct CourseSystemName {
  std::string student;       ///< equal for the files of a student only
  std::string name;          ///< to show
  std::string id;            ///< that distinguishes students of the same name; may be empty
  std::string attempt;       ///< later ones are greater; empty: files of all attempts count
  std::uint64_t number = 0;  ///< of the file; later ones are greater
  bool late = false;         ///< handed in late
  std::string original;      ///< the name of the file before, with its extension; may be empty
};

/// Parses the name of a file or folder. Returns false if it has no such form.
bool read_course_system_name(std::string_view name, CourseSystemName& result);

/// The names of students by folder in Gradescope's submission_metadata.yml.
std::map<std::string, std::string> read_gradescope_names(std::string_view text);

/// The bounds of the archive of a class; those in it have the usual ones.
inline constexpr ArchiveBudget class_archive_budget{1'000'000, std::uint64_t{1} << 36};

/// Reads files that are in archives, each archive once: a result for each file. `budget`: of each
/// of the outermost archives.
std::vector<Result<std::string>> read_archived(const std::vector<FoundFile>& files,
                                               const ArchiveBudget& budget = {});

}  // namespace scenefile
