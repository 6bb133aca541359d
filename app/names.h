#pragma once
// The words of the format for its closed sets, in the order of their enumerators.

#include <array>
#include <string_view>

namespace scenefile::app {

inline constexpr std::array<std::string_view, 5> shape_names{"cube", "cone", "cylinder", "sphere",
                                                             "mesh"};
inline constexpr std::array<std::string_view, 4> light_names{"point", "directional", "spot",
                                                             "area"};
inline constexpr std::array<std::string_view, 9> face_names{"side", "top", "bottom", "+x", "-x",
                                                            "+y",   "-y",  "+z",     "-z"};
inline constexpr std::array<std::string_view, 3> mode_names{"ray", "intersect", "normals"};

}  // namespace scenefile::app
