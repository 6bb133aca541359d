#include "scenefile/gradebook/gradebook.h"
#include "scenefile/gradebook/markup.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

std::string test_case(const StudentResult& student, const PictureResult& picture) {
  std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\"", markup(student.name),
                                markup(picture.name));
  if (picture.verdict == Verdict::passed) {
    return xml + "/>\n";
  }
  std::string message;
  for (const std::string& reason : picture.reasons) {
    message += (message.empty() ? "" : "; ") + reason;
  }
  std::string body;
  for (const Claim& claim : picture.causes) {
    body += fmt::format("cause: {} ({})\n", claim.what, claim.evidence);
  }
  for (const std::string& note : picture.notes) {
    body += fmt::format("note: {}\n", note);
  }
  return xml + fmt::format(
                   ">\n      <failure type=\"{}\" message=\"{}\">{}</failure>\n"
                   "    </testcase>\n",
                   name_of(picture.verdict), markup(message), markup(body));
}

}  // namespace

std::string gradebook_junit(const Gradebook& book) {
  const std::size_t passed = book.count(Verdict::passed);
  const std::size_t failed =
      book.count(Verdict::differs) + book.count(Verdict::missing) + book.count(Verdict::unreadable);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{}\" failures=\"{}\">\n",
      passed + failed, failed);
  for (const StudentResult& student : book.students) {
    xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
                       markup(student.name), student.pictures.size(),
                       student.pictures.size() - student.passed());
    for (const PictureResult& picture : student.pictures) {
      xml += test_case(student, picture);
    }
    if (const std::vector<std::string> ignored = ignored_lines(book, student.name);
        !ignored.empty()) {
      xml += fmt::format("    <system-out>not graded:\n{}</system-out>\n",
                         markup(fmt::format("{}\n", fmt::join(ignored, "\n"))));
    }
    xml += "  </testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

}  // namespace scenefile
