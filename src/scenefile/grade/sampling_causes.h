#pragma once
// Causes about the samples of pixels: blur, samples that miss, rays that miss the centers of
// pixels. Internal to grade.

#include "scenefile/grade/candidates.h"

#include <span>

namespace scenefile {

/// A note if other samples per pixel, or filtered textures, explain all of the points. Otherwise
/// drops the points that they explain, if these are the majority.
/// `points` only has pixels that differ, chosen from `different`.
std::optional<Claim> drop_other_samples(Simulation& sim,
                                        const std::vector<std::uint32_t>& different);
/// Pixels are black if any of their samples hits nothing, which gives black outlines, one pixel
/// wide.
std::optional<Claim> claim_of_missed_samples(Simulation& sim);
/// Each pixel is a mean of several of the reference.
std::optional<Claim> claim_of_blur(Simulation& sim, const Pixels& pixels);
/// The mistakes to try that show at edges.
std::vector<std::uint16_t> edge_mistakes(const Simulation& sim);
/// Adds a mistake in sampling if the edges of the picture show one.
Tried with_edges(Simulation& sim, const Tried& found);
/// A shift, by less than a pixel or by another camera, that explains the edges best. Subpixel
/// shifts are only visible there.
std::optional<Tried> find_shift(Simulation& sim, const Pixels& pixels);
/// Whether the shift is by less than a pixel.
bool is_subpixel(const Simulation& sim, const Tried& shift);

}  // namespace scenefile
