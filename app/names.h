#pragma once
// The formats that `scenefile convert` writes.

#include "scenefile/base/shape.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace scenefile::app {

enum class ConvertTo : std::uint8_t { xml, json, pov, glb, gltf, obj };

/// The word for --to, which is also the extension of file names.
constexpr std::string_view word_of(ConvertTo format) {
  switch (format) {
    case ConvertTo::xml:
      return "xml";
    case ConvertTo::json:
      return "json";
    case ConvertTo::pov:
      return "pov";
    case ConvertTo::glb:
      return "glb";
    case ConvertTo::gltf:
      return "gltf";
    case ConvertTo::obj:
      return "obj";
  }
  return {};
}
inline constexpr auto format_words = words_of<ConvertTo>();

/// The name in messages.
constexpr std::string_view format_name(ConvertTo format) {
  switch (format) {
    case ConvertTo::xml:
      return "XML";
    case ConvertTo::json:
      return "JSON";
    case ConvertTo::pov:
      return "POV-Ray";
    case ConvertTo::glb:
      return "GLB";
    case ConvertTo::gltf:
      return "glTF";
    case ConvertTo::obj:
      return "OBJ";
  }
  return {};
}

}  // namespace scenefile::app
