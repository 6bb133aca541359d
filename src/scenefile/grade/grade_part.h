#pragma once
// The file with the results of one part of a class, for graders on several machines.
//
//   scenefile grades 3    one line; the number is the version of the format
//   checksum              8 bytes, of all that follows
//   header                GradePartHead
//   gradebook             its students with their pictures, and the ignored files
//
// Numbers have the byte order of the machine; builds for other machines have other keys.

#include "scenefile/grade/gradebook.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// Fingerprints (base/hash.h) of everything that a class is graded from.
struct GradeKey {
  std::uint64_t program = 0;     ///< the build
  std::uint64_t students = 0;    ///< names of all students
  std::uint64_t references = 0;  ///< reference pictures, and their scenes with all assets
  std::uint64_t options = 0;     ///< all other settings that affect results

  friend bool operator==(const GradeKey&, const GradeKey&) = default;
};

/// What all parts of a class have in common.
struct DividedClass {
  GradeKey key;
  std::uint32_t count = 1;     ///< number of parts
  std::uint32_t students = 0;  ///< of the whole class
  std::uint64_t pictures = 0;  ///< expected of the whole class

  friend bool operator==(const DividedClass&, const DividedClass&) = default;
};

struct GradePartHead {
  DividedClass whole;
  std::uint32_t index = 0;        ///< counted from 0; its students are those of students_of()
  std::uint64_t submissions = 0;  ///< fingerprint of the pictures of its students

  friend bool operator==(const GradePartHead&, const GradePartHead&) = default;
};

/// Students, counted from 0 in the order of their names: `begin` up to, but not including, `end`.
struct StudentRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The students of a part. Each student is in exactly one part; the sizes of parts differ by at
/// most one.
StudentRange students_of(std::uint32_t index, std::uint32_t count, std::size_t students);

std::string encode_grade_part(const GradePartHead& head, const Gradebook& book);

/// Decodes the result of encode_grade_part(). Returns an error message, empty on success.
std::string decode_grade_part(std::string_view bytes, GradePartHead& head, Gradebook& book);

/// Whether the file is a part of a class, written by any version.
bool is_grade_part(std::string_view first_bytes);

/// Why a part with the key `found` does not belong to the class with the key `wanted`, as a phrase
/// that completes "it was graded ..."; empty if it does.
std::string_view foreign_grade_part(const GradeKey& found, const GradeKey& wanted);

}  // namespace scenefile
