#pragma once
// Generated scenes of any size, for measurements.

#include <cstddef>
#include <string>

namespace scenefile::bench {

/// XML text with `count` transblocks, each with translate, rotate, scale and a cube of a different
/// color; 283 bytes each.
std::string xml_scene(std::size_t count);

/// The same scene in JSON.
std::string json_scene(std::size_t count);

/// XML text of a scene whose root has ten instances of a template with ten instances of a template
/// and so on: 10^levels spheres.
std::string nested_scene(int levels);

}  // namespace scenefile::bench
