#include "laws/law.h"
#include "scenefile/edit/format_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace scenefile::laws {

namespace {

constexpr std::size_t cuts = 40;

struct Reading {
  Scene scene;
  std::vector<const Code*> codes;
};

Reading read(std::string_view text) {
  Diagnostics diagnostics;
  Reading reading{read_scene(text, {}, diagnostics), {}};
  for (const Diagnostic& d : diagnostics.list()) {
    reading.codes.push_back(d.code);
  }
  std::sort(reading.codes.begin(), reading.codes.end());
  return reading;
}

std::optional<std::string> laid_out(std::string_view text) {
  Diagnostics ignored;
  return lay_out(text, {}, ignored);
}

// In XML, including their white space.
std::vector<std::string_view> comments_of(std::string_view text) {
  std::vector<std::string_view> comments;
  for (std::size_t at = 0; (at = text.find("<!--", at)) != text.npos;) {
    const std::size_t end = std::min(text.find("-->", at), text.size());
    comments.push_back(text.substr(at, end - at));
    at = end;
  }
  return comments;
}

bool is_refused(std::string_view text) {
  Diagnostics diagnostics;
  read_scene(text, {}, diagnostics);
  return diagnostics.has_errors();
}

}  // namespace

void try_text_laws(std::string_view text, Breaches& breaches) {
  const std::optional<std::string> once = laid_out(text);
  if (!once) {
    return;
  }
  if (laid_out(*once) != *once) {
    breaches.push_back("laying it out twice is not laying it out once");
  }
  if (comments_of(*once) != comments_of(text)) {
    breaches.push_back("laying it out changes its comments");
  }
  const Reading before = read(text);
  const Reading after = read(*once);
  // NaN, for numbers that could not be read, is not equal to itself.
  const bool same = before.scene.incomplete || before.scene == after.scene;
  if (!same || before.codes != after.codes) {
    breaches.push_back("laying it out changes the scene or what is said of it");
  }
  const std::size_t end = text.find_last_of(">}");
  for (std::size_t i = 0; i < cuts; ++i) {
    const std::size_t cut = end * i / cuts;
    if (!is_refused(text.substr(0, cut))) {
      breaches.push_back(fmt::format("its first {} bytes are taken for a scene", cut));
    }
  }
}

}  // namespace scenefile::laws
