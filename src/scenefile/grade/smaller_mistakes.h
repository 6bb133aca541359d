#pragma once
// Looks for a mistake that shows at few pixels, beside those that explain nearly all others.
// Internal to grade.

#include "scenefile/grade/simulation.h"

namespace scenefile {

/// Adds the mistakes that explain the few pixels that `found` leaves unexplained. Examines far more
/// pixels than the simulation's points; if it finds a mistake, they become the new points.
Tried with_smaller_mistakes(Simulation& sim, const Pixels& pixels, Tried found);

}  // namespace scenefile
