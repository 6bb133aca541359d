#pragma once
// Causes about the samples of pixels: blur, samples that miss, rays that miss the centers of
// pixels. Internal to grade.

#include "scenefile/grade/candidates.h"

namespace scenefile {

/// Pixels are black if any of their samples hits nothing, which gives black outlines, one pixel
/// wide.
std::optional<Claim> claim_of_missed_samples(Simulation& sim);
/// Each pixel is a mean of several of the reference.
std::optional<Claim> claim_of_blur(Simulation& sim, const Pixels& pixels);
/// The subpixel shifts among the mistakes to try.
std::vector<std::uint16_t> subpixel_shifts(const Simulation& sim);
/// Adds a claim of a subpixel shift if the edges of the picture show one.
Tried with_shift(Simulation& sim, const Tried& found);
/// Subpixel shifts are only visible at edges.
std::optional<Tried> find_shift(Simulation& sim, const Pixels& pixels);

}  // namespace scenefile
