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

/// The elements of an accessor with `components` numbers each, consecutively. Integers become
/// fractions if they are `normalized`. Fails if anything is invalid or a value is not finite; the
/// text of the error follows "accessors[1]".
Result<std::vector<float>> read_floats(const GltfFile& file, std::uint32_t accessor,
                                       std::size_t components);

/// Same for indices.
Result<std::vector<std::uint32_t>> read_indices(const GltfFile& file, std::uint32_t accessor);

}  // namespace scenefile
