#pragma once
// What a class handed in, against the references: results as data, and as text, HTML and JUnit XML.

#include "scenefile/compare/measure.h"
#include "scenefile/grade/causes.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

enum class Verdict : std::uint8_t { passed, differs, missing, unreadable };

/// "passed", "differs", "missing" or "unreadable".
std::string_view name_of(Verdict verdict);

/// One picture of one student.
struct PictureResult {
  std::string name;  ///< of the reference, without its ending
  Verdict verdict = Verdict::passed;
  PictureMeasures measures;          ///< where there is a picture
  std::vector<std::string> reasons;  ///< why it did not pass, as clauses
  std::vector<Claim> causes;         ///< known mistakes that explain it
  std::string png;                   ///< reference, picture and heat map as a PNG; may be empty
};

struct StudentResult {
  std::string name;
  std::vector<PictureResult> pictures;  ///< in the order of the references

  std::size_t passed() const;
};

struct Gradebook {
  std::vector<StudentResult> students;

  /// How many pictures of all students have that verdict.
  std::size_t count(Verdict verdict) const;
  bool all_passed() const;
};

/// A line for each student, below it one for each picture that did not pass, and a last line that
/// counts. Names are printed as they are: for a terminal the caller escapes them.
std::string gradebook_text(const Gradebook& book);

/// One page that needs no other file: a table of students and pictures, and what is wrong with each
/// picture that did not pass.
std::string gradebook_html(const Gradebook& book, std::string_view title);

/// A test suite for each student, a test case for each picture.
std::string gradebook_junit(const Gradebook& book);

}  // namespace scenefile
