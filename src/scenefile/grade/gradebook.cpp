#include "scenefile/grade/gradebook.h"

#include "scenefile/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scenefile {

namespace {

// "PSNR is 31.20 dB, less than 40; cause: there are no shadows".
std::string reasons_text(const PictureResult& picture) {
  std::string text;
  for (const std::string& reason : picture.reasons) {
    text += (text.empty() ? "" : "; ") + reason;
  }
  for (const Claim& claim : picture.causes) {
    text += "; cause: " + claim.what;
  }
  return text;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"passed", "differs", "missing",
                                                         "unreadable"};
  return names[static_cast<std::size_t>(verdict)];
}

std::size_t StudentResult::passed() const {
  return static_cast<std::size_t>(
      std::count_if(pictures.begin(), pictures.end(),
                    [](const PictureResult& p) { return p.verdict == Verdict::passed; }));
}

std::size_t Gradebook::count(Verdict verdict) const {
  std::size_t sum = 0;
  for (const StudentResult& student : students) {
    sum += static_cast<std::size_t>(
        std::count_if(student.pictures.begin(), student.pictures.end(),
                      [&](const PictureResult& p) { return p.verdict == verdict; }));
  }
  return sum;
}

bool Gradebook::all_passed() const {
  return std::all_of(students.begin(), students.end(), [](const StudentResult& student) {
    return student.passed() == student.pictures.size();
  });
}

std::string gradebook_text(const Gradebook& book) {
  std::size_t width = 0;
  for (const StudentResult& student : book.students) {
    width = std::max(width, escaped(student.name).size());
  }
  std::string text;
  for (const StudentResult& student : book.students) {
    text += fmt::format("{:<{}}  {} of {} passed\n", escaped(student.name), width, student.passed(),
                        student.pictures.size());
    for (const PictureResult& picture : student.pictures) {
      if (picture.verdict != Verdict::passed) {
        text += fmt::format("    {}: {}: {}\n", escaped(picture.name), name_of(picture.verdict),
                            reasons_text(picture));
      }
    }
  }
  return text + fmt::format(
                    "{} student{}: {} pictures passed, {} differ, {} missing, {} "
                    "unreadable\n",
                    book.students.size(), book.students.size() == 1 ? "" : "s",
                    book.count(Verdict::passed), book.count(Verdict::differs),
                    book.count(Verdict::missing), book.count(Verdict::unreadable));
}

}  // namespace scenefile
