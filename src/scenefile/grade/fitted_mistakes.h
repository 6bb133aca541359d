#pragma once
// Mistakes with a number that is estimated from the pictures, such as a factor. Internal to grade.

#include "scenefile/grade/simulation.h"

namespace scenefile {

/// Brightness, contrast and gamma, of all values or by channel, estimated from the colors of the
/// reference at the points. `cut_off`: by how much values are too low on average, in 1/255: 0.5 if
/// they are truncated, 0 if they are rounded.
std::vector<Hypothesis> fitted_curves(const std::vector<Point>& points, const Colors& reference,
                                      double cut_off = 0.5);
/// A number added to all colors but black. Only for pictures with a scene, because in a scene with
/// one material, a wrong ambient term gives the same picture.
std::optional<Hypothesis> addition_to_objects(const std::vector<Point>& points,
                                              const Colors& reference);
/// Whether a curve reproduces the test everywhere: at nearly all points that it changes, except at
/// edges of the reference, and at all levels of brightness. A curve that only approximates another
/// one has errors that depend on the brightness. The points must be spread over the whole picture.
/// `without`: the colors before the curve; `with`: after it.
bool curve_holds(const Texture& reference, const std::vector<Point>& points, const Colors& without,
                 const Colors& with);
/// Factors of the finished picture, to be combined with other mistakes: those that explain many
/// values within rounding, beside some other mistake. Needs the cache.
void add_factors_of_picture(Simulation& sim);
/// A camera that shows objects larger or smaller, or stretched.
void add_zooms(Simulation& sim);
/// A uniform color where nothing is hit.
void add_background(Simulation& sim);
/// Terms and lights that are too bright or too dark by a factor, estimated from the pictures.
void add_factors(Simulation& sim);
/// Exponents of highlights, where a known mistake in them explains a part. Needs the cache.
void add_exponents(Simulation& sim);
/// Objects of the file that are not drawn.
void add_missing_objects(Simulation& sim);

}  // namespace scenefile
