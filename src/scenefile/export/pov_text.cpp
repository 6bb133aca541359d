#include "scenefile/export/pov_text.h"

#include <fmt/format.h>

namespace scenefile {

std::string pov_vector(const glm::dvec3& v) {
  return fmt::format("<{}, {}, {}>", v.x, v.y, v.z);
}

std::string pov_vector(const glm::vec3& v) {
  return fmt::format("<{}, {}, {}>", v.x, v.y, v.z);
}

std::string pov_color(const glm::vec3& color) {
  return fmt::format("rgb {}", pov_vector(color));
}

// POV-Ray multiplies row vectors from the left: each of its rows is a column here.
std::string pov_matrix(const Affine& map) {
  if (map == Affine{}) {
    return {};
  }
  const glm::mat3& m = map.linear;
  return fmt::format("matrix <{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}>", m[0].x, m[0].y,
                     m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z, map.offset.x,
                     map.offset.y, map.offset.z);
}

std::string pov_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  return result + '"';
}

}  // namespace scenefile
