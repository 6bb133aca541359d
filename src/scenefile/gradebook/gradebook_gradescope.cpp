#include "scenefile/base/text.h"
#include "scenefile/gradebook/gradebook.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

// A JSON string.
std::string quoted_json(std::string_view text) {
  std::string result = "\"";
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      default:
        result +=
            static_cast<unsigned char>(c) < ' '
                ? fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)))
                : std::string(1, c);
    }
  }
  return result + "\"";
}

std::string output_of(const PictureResult& picture) {
  std::string text;
  for (const std::string& reason : picture.reasons) {
    text += escaped(reason) + "\n";
  }
  for (const Claim& claim : picture.causes) {
    text += fmt::format("Cause: {} [{}]\n  {}\n", claim.what, name_of(claim.cause), claim.evidence);
  }
  for (const Claim& claim : picture.partial) {
    text +=
        fmt::format("In part: {} [{}]\n  {}\n", claim.what, name_of(claim.cause), claim.evidence);
  }
  for (const std::string& note : picture.notes) {
    text += fmt::format("Note: {}\n", escaped(note));
  }
  return text;
}

}  // namespace

std::string gradescope_json(const StudentResult& student) {
  std::string json = fmt::format(
      "{{\n  \"score\": {},\n  \"output_format\": \"text\",\n  \"tests\": [", student.passed());
  for (std::size_t i = 0; i < student.pictures.size(); ++i) {
    const PictureResult& picture = student.pictures[i];
    const bool passed = picture.verdict == Verdict::passed;
    std::string tags;
    for (const Cause cause : distinct_causes(picture)) {
      tags += fmt::format("{}\"{}\"", tags.empty() ? "" : ", ", name_of(cause));
    }
    json += fmt::format(
        "{}\n    {{\"name\": {}, \"number\": \"{}\", \"score\": {}, \"max_score\": 1, \"status\": "
        "\"{}\", \"output\": {}, \"tags\": [{}], \"visibility\": \"visible\"}}",
        i == 0 ? "" : ",", quoted_json(escaped(picture.name)), i + 1, passed ? 1 : 0,
        passed ? "passed" : "failed", quoted_json(output_of(picture)), tags);
  }
  return json + "\n  ]\n}\n";
}

}  // namespace scenefile
