#pragma once
// Scenes of any size for measurements.

#include <cstddef>
#include <string>

namespace scenefile::bench {

/// The XML text of a scene of so many transblocks, each with translate, rotate, scale and a cube of
/// its own color; 283 bytes each.
std::string xml_scene(std::size_t count);

/// The same scene in JSON.
std::string json_scene(std::size_t count);

/// XML of a scene whose root holds ten copies of a template that holds ten copies of a template and
/// so on: 10^levels spheres.
std::string nested_scene(int levels);

}  // namespace scenefile::bench
