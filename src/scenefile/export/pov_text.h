#pragma once
// Values in POV-Ray's language. Internal to export.

#include "scenefile/base/affine.h"

#include <glm/glm.hpp>

#include <string>
#include <string_view>

namespace scenefile {

/// `<x, y, z>`, each with the fewest digits that give the same value.
std::string pov_vector(const glm::dvec3& v);
std::string pov_vector(const glm::vec3& v);

/// `rgb <r, g, b>`.
std::string pov_color(const glm::vec3& color);

/// `matrix <...>`; empty for the identity.
std::string pov_matrix(const Affine& map);

/// A quoted string, escaped for POV-Ray.
std::string pov_string(std::string_view text);

}  // namespace scenefile
