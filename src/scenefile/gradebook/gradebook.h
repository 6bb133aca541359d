#pragma once
// The results of comparing a class's pictures with the references, as data and as text, HTML, CSV,
// JUnit XML and Gradescope's results.json.

#include "scenefile/compare/measure.h"
#include "scenefile/mistakes/cause.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class Verdict : std::uint8_t { passed, differs, missing, unreadable };

/// "passed", "differs", "missing" or "unreadable".
std::string_view name_of(Verdict verdict);

/// A picture of a student.
struct PictureResult {
  std::string name;  ///< of the reference, without extension
  Verdict verdict = Verdict::passed;
  /// If there is a picture. If its size differs from that of the reference, both have been compared
  /// at one size, or `comparable` is false.
  PictureMeasures measures;
  std::vector<std::string> reasons;  ///< why it did not pass, as clauses
  std::vector<Claim> causes;         ///< mistakes that explain it
  std::vector<Claim> rivals;         ///< other mistakes that explain it almost as well
  std::vector<Claim> partial;        ///< mistakes that explain a part: something else is wrong too
  std::vector<std::string> notes;    ///< what else is worth knowing, as clauses
  /// Reference, picture and heat map next to each other as a PNG, each a third of its width; empty
  /// without a picture.
  std::string png;
  std::string png_file;           ///< if not embedded: path relative to the page
  std::uint64_t fingerprint = 0;  ///< of the file (base/hash.h); 0: there is none
  std::string identical;          ///< students with the same file, if there are several
  bool path_traced = false;       ///< judged by statistics, without `measures`
};

struct StudentResult {
  std::string name;
  std::vector<PictureResult> pictures;      ///< in the order of the references
  std::vector<std::string> unmatched = {};  ///< paths of pictures that show no reference, by name

  std::size_t passed() const;
};

/// A file of the class that was not graded.
struct IgnoredFile {
  std::string path;     ///< below the folder of the class
  std::string student;  ///< whose file it is; empty: unknown
  std::string reason;   ///< a clause

  friend bool operator==(const IgnoredFile&, const IgnoredFile&) = default;
};

struct Gradebook {
  std::vector<StudentResult> students;
  /// First those of unknown students, then the others, in the order of the students.
  std::vector<IgnoredFile> ignored = {};
  std::string name = {};                ///< of the folder of the class
  std::vector<std::string> notes = {};  ///< decisions that the grader may not expect

  /// The number of pictures of all students with that verdict.
  std::size_t count(Verdict verdict) const;
  bool all_passed() const;
};

/// Sets PictureResult::identical, for the whole class: "ada, ben".
void find_identical_files(Gradebook& book);

/// The groups of identical files: "chess: ada, ben". Neutral: nobody need have copied.
std::vector<std::string> identical_lines(const Gradebook& book);

/// "2 pictures match no reference: a.png, b.png"; empty if there are none, or if no picture is
/// missing: students may hand in more than was asked for.
std::string unmatched_text(const StudentResult& student);

/// "old.zip: protected by a password". Files of one student with the same reason share a line:
/// "ada/main.cpp and 11 more: not a picture".
std::vector<std::string> ignored_lines(const Gradebook& book);
/// Only those of a student.
std::vector<std::string> ignored_lines(const Gradebook& book, std::string_view student);

/// A line for each student, followed by one for each picture that did not pass, identical and
/// ignored files, and a summary line. Escaped for terminals.
std::string gradebook_text(const Gradebook& book);

/// The causes of a picture, each once: several claims may have the same cause.
std::vector<Cause> distinct_causes(const PictureResult& picture);

/// How many pictures a cause explains.
struct CauseCount {
  Cause cause = Cause::rounding;
  std::size_t pictures = 0;
  std::size_t students = 0;
};

/// The causes of a class or of one student, the most frequent first.
std::vector<CauseCount> count_causes(std::span<const StudentResult> students);

/// The report of a class as an HTML page: a table of students and pictures that can be sorted and
/// filtered, the mistakes with where to look, and the pictures. Self-contained, except for the
/// files in PictureResult::png_file. `date` is shown as it is, if not empty.
std::string gradebook_html(const Gradebook& book, std::string_view title,
                           std::string_view date = {});

/// The report for one student, to return to them; it contains nothing about the class. `ignored`:
/// lines about their files (ignored_lines()).
std::string student_html(const StudentResult& student, std::string_view title,
                         std::string_view date = {}, const std::vector<std::string>& ignored = {});

/// One line per picture of each student, as CSV (RFC 4180) with a header line. An apostrophe is put
/// before text that a spreadsheet would interpret as a formula.
std::string gradebook_csv(const Gradebook& book);

/// One line per student, as CSV like gradebook_csv(): the score is the number of pictures that
/// passed.
std::string students_csv(const Gradebook& book);

/// The results of one student in Gradescope's format (results.json): one test and one point per
/// picture.
std::string gradescope_json(const StudentResult& student);

/// A test suite for each student, with a test case for each picture.
std::string gradebook_junit(const Gradebook& book);

}  // namespace scenefile
