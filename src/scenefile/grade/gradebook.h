#pragma once
// What a class handed in, against the references: results as data, and as text, HTML, CSV, JUnit
// XML and Gradescope's results.json.

#include "scenefile/compare/measure.h"
#include "scenefile/grade/causes.h"

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
  PictureMeasures measures;          ///< if there is a picture
  std::vector<std::string> reasons;  ///< why it did not pass, as clauses
  std::vector<Claim> causes;         ///< mistakes that explain it
  std::string png;                   ///< reference, picture and heat map as a PNG; may be empty
  std::string png_file;              ///< where that lies beside the page, instead of in it
};

struct StudentResult {
  std::string name;
  std::vector<PictureResult> pictures;  ///< in the order of the references

  std::size_t passed() const;
};

struct Gradebook {
  std::vector<StudentResult> students;

  /// The number of pictures of all students with that verdict.
  std::size_t count(Verdict verdict) const;
  bool all_passed() const;
};

/// A line for each student, followed by one for each picture that did not pass, and a summary line.
/// Names are printed unchanged; callers must escape them for terminals.
std::string gradebook_text(const Gradebook& book);

/// How many pictures a cause explains.
struct CauseCount {
  Cause cause = Cause::rounding;
  std::size_t pictures = 0;
  std::size_t students = 0;
};

/// The causes of a class or of one student, the most frequent first.
std::vector<CauseCount> count_causes(std::span<const StudentResult> students);

/// A page: a table of students and pictures that can be sorted and filtered, the causes of the
/// class, and what is wrong with each picture that did not pass. It needs no other file but those
/// that PictureResult::png_file names.
std::string gradebook_html(const Gradebook& book, std::string_view title);

/// A page for one student, to hand back: without the table of the class.
std::string student_html(const StudentResult& student, std::string_view title);

/// A line for each picture of each student, fields as RFC 4180 has them, the names of the fields
/// first. Text that a spreadsheet would take for a formula gets an apostrophe before it.
std::string gradebook_csv(const Gradebook& book);

/// The results of one student as Gradescope reads them (results.json): a test for each picture, a
/// point for each that passed.
std::string gradescope_json(const StudentResult& student);

/// A test suite for each student, with a test case for each picture.
std::string gradebook_junit(const Gradebook& book);

}  // namespace scenefile
