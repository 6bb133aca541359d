#pragma once
// Lists of numbers in a glTF file. Private to the room.

#include "scenefile/import/gltf_file.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace scenefile {

/// How many elements the accessor says it has; 0 where that is not a number.
std::uint64_t element_count(const GltfFile& file, std::uint32_t accessor);

/// The elements of an accessor of `components` numbers each, one after the other. Whole numbers
/// count as fractions where they are `normalized`. False with the reason, in words that follow
/// "accessors[1]", when it is wrong in any way or a value is not finite.
bool read_floats(const GltfFile& file, std::uint32_t accessor, std::size_t components,
                 std::vector<float>& values, std::string& error);

/// The same for indices.
bool read_indices(const GltfFile& file, std::uint32_t accessor, std::vector<std::uint32_t>& values,
                  std::string& error);

}  // namespace scenefile
