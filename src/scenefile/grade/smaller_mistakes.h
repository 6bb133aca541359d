#pragma once
// Looks for a mistake that shows at few pixels, beside those that explain nearly all others.
// Internal to grade.

#include "scenefile/grade/simulation.h"

namespace scenefile {

/// The mistakes with those in addition that explain the few pixels that they leave. Looks at far
/// more pixels than the simulation's points; where it finds a mistake, these become its points.
Tried with_smaller_mistakes(Simulation& sim, const Pixels& pixels, Tried found);

}  // namespace scenefile
