#pragma once
// Arrays of numbers in a glTF file. Internal to import.

#include "scenefile/import/gltf_file.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// The element count that the accessor declares; 0 if it is not a number.
std::uint64_t element_count(const GltfFile& file, std::uint32_t accessor);

/// Reads the elements of an accessor with `components` numbers each, consecutively. Integers become
/// fractions if they are `normalized`. If anything is invalid or a value is not finite, returns
/// false and the reason, as a phrase that follows "accessors[1]".
bool read_floats(const GltfFile& file, std::uint32_t accessor, std::size_t components,
                 std::vector<float>& values, std::string& error);

/// Same for indices.
bool read_indices(const GltfFile& file, std::uint32_t accessor, std::vector<std::uint32_t>& values,
                  std::string& error);

}  // namespace scenefile
