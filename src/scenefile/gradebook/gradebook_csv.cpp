#include "scenefile/base/text.h"
#include "scenefile/gradebook/gradebook.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

// Spreadsheets evaluate text that starts like a formula, and names come from students.
std::string field(std::string_view text) {
  std::string result = "\"";
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) {
    result += '\'';
  }
  for (const char c : valid_utf8(text)) {
    result += c == '"' ? "\"\"" : std::string(1, c);
  }
  return result + "\"";
}

// "64x48"; empty if there is no picture.
std::string size_text(const glm::ivec2& size) {
  return size == glm::ivec2(0) ? std::string() : fmt::format("{}x{}", size.x, size.y);
}

std::string row(const StudentResult& student, const PictureResult& picture) {
  std::string causes;
  for (const Cause cause : distinct_causes(picture)) {
    causes += fmt::format("{}{}", causes.empty() ? "" : " ", name_of(cause));
  }
  std::string words;
  for (const Claim& claim : picture.causes) {
    words += (words.empty() ? "" : "; ") + claim.what;
  }
  std::string reasons;
  for (const std::string& reason : picture.reasons) {
    reasons += (reasons.empty() ? "" : "; ") + reason;
  }
  std::string notes;
  for (const std::string& note : picture.notes) {
    notes += (notes.empty() ? "" : "; ") + note;
  }
  if (!picture.identical.empty()) {
    notes += fmt::format("{}identical files: {}", notes.empty() ? "" : "; ", picture.identical);
  }
  const PictureMeasures& m = picture.measures;
  const bool measured = m.comparable && !picture.path_traced &&
                        (picture.verdict == Verdict::passed || picture.verdict == Verdict::differs);
  const std::string figures =
      measured ? fmt::format("{:.2f},{:.4f},{:.4f}", m.difference.psnr_db, m.ssim, m.flip_mean)
               : ",,";
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\r\n", field(student.name), field(picture.name),
                     name_of(picture.verdict), size_text(m.size), size_text(m.right_size), figures,
                     field(causes), field(words), field(reasons), field(notes));
}

}  // namespace

std::string students_csv(const Gradebook& book) {
  std::string csv = "student,score,max_score,differs,missing,unreadable,ignored\r\n";
  for (const StudentResult& student : book.students) {
    const auto with = [&](Verdict verdict) {
      return std::count_if(student.pictures.begin(), student.pictures.end(),
                           [&](const PictureResult& p) { return p.verdict == verdict; });
    };
    const auto ignored =
        std::count_if(book.ignored.begin(), book.ignored.end(),
                      [&](const IgnoredFile& file) { return file.student == student.name; });
    csv += fmt::format("{},{},{},{},{},{},{}\r\n", field(student.name), student.passed(),
                       student.pictures.size(), with(Verdict::differs), with(Verdict::missing),
                       with(Verdict::unreadable), ignored);
  }
  return csv;
}

std::string gradebook_csv(const Gradebook& book) {
  std::string csv =
      "student,picture,verdict,size,expected_size,psnr_db,ssim,flip,causes,what,reasons,notes\r\n";
  for (const StudentResult& student : book.students) {
    for (const PictureResult& picture : student.pictures) {
      csv += row(student, picture);
    }
  }
  return csv;
}

}  // namespace scenefile
