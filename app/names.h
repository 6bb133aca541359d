#pragma once
// Names of enumerators, indexed by enumerator. The format's names are in base/shape.h.

#include <array>
#include <string_view>

namespace scenefile::app {

/// Output formats, which are also their file name extensions.
inline constexpr std::array<std::string_view, 6> format_words{"xml", "json", "pov",
                                                              "glb", "gltf", "obj"};

}  // namespace scenefile::app
