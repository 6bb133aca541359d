#include "scenefile/import/mesh_text.h"

#include "scenefile/base/number.h"

#include <fmt/format.h>

#include <iterator>

namespace scenefile {

std::string obj_text(const TriangleList& list) {
  std::string text;
  const auto line = [&](std::string_view word, std::initializer_list<float> values) {
    text += word;
    for (const float value : values) {
      text += ' ';
      text += number_text(value);
    }
    text += '\n';
  };
  for (const glm::vec3& p : list.positions) {
    line("v", {p.x, p.y, p.z});
  }
  for (const glm::vec2& uv : list.uvs) {
    line("vt", {uv.x, uv.y});
  }
  for (const glm::vec3& n : list.normals) {
    line("vn", {n.x, n.y, n.z});
  }
  for (std::size_t i = 0; i + 2 < list.indices.size(); i += 3) {
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t corner = std::uint64_t{list.indices[i + k]} + 1;
      auto out = std::back_inserter(text);
      if (list.uvs.empty() && list.normals.empty()) {
        fmt::format_to(out, " {}", corner);
      } else if (list.normals.empty()) {
        fmt::format_to(out, " {}/{}", corner, corner);
      } else if (list.uvs.empty()) {
        fmt::format_to(out, " {}//{}", corner, corner);
      } else {
        fmt::format_to(out, " {}/{}/{}", corner, corner, corner);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace scenefile
