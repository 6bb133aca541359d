#include "scenefile/mistakes/cause.h"

namespace scenefile {

std::string_view name_of(Cause cause) {
  static constexpr std::array<std::string_view, cause_count> names{
      "vertical-flip",    "horizontal-flip", "gamma",         "rounding",   "swapped-channels",
      "half-pixel-shift", "ambient",         "diffuse",       "specular",   "blinn",
      "attenuation",      "normals",         "shadows",       "acne",       "texture",
      "recursion-depth",  "spot-falloff",    "camera",        "transforms", "shapes",
      "nearest-hit",      "lights",          "reflection",    "refraction", "overflow",
      "background",       "brightness",      "black",         "features",   "samples",
      "scene-edited",     "tessellation",    "facets",        "culling",    "clipping",
      "filter",           "viewport",        "light-samples", "scattering", "path-length",
      "specular-paths"};
  return names[static_cast<std::size_t>(cause)];
}

}  // namespace scenefile
