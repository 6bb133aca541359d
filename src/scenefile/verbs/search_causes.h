#pragma once
// The search for the causes of a difference, by the kind of the pictures: exact, JPEG, scaled, with
// a palette. Internal to verbs.

#include "scenefile/trace/render.h"
#include "scenefile/verbs/compare_pictures.h"

#include <functional>
#include <vector>

namespace scenefile {

/// Looks for causes, and for the place where the pictures differ most; uses the scene if there are
/// ways to draw it. `noisy`: the colors are not those that were drawn.
void look_for_causes(const Texture& reference, const Texture& test, const LoadedScene* scene,
                     const std::vector<DrawnWay>& ways, const ComparedPart& part, bool noisy,
                     const CompareSettings& settings, const std::function<bool(double)>& go_on,
                     PictureComparison& found);

/// CompareSettings::ways, those that fit the reference.
std::vector<DrawnWay> ways_of(const Texture& reference, const LoadedScene& scene,
                              const CompareSettings& settings);

/// Our picture of the scene. Throws std::bad_alloc if memory runs out, because a partial
/// result could name another cause.
RenderResult our_picture(const LoadedScene& scene, const RenderOptions& options,
                         RenderControl control = {});

}  // namespace scenefile
