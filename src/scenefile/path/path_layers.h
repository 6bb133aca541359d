#pragma once
// Layers and guides of a path-traced picture, from what paths record.

#include "scenefile/path/path_record.h"
#include "scenefile/path/path_state.h"
#include "scenefile/trace/denoise.h"

namespace scenefile {

/// An outlier is limited by the pixels up to this far from it.
inline constexpr int outlier_reach = 2;
/// Pixels farther away have no effect on a denoised one.
inline constexpr int path_denoise_reach = denoise_reach + outlier_reach;

/// Adds a path to the layers and guides of pixel `at`.
void add_layers(const PathRecord& path, const RenderOptions& options, std::size_t at,
                PathState& state);

}  // namespace scenefile
