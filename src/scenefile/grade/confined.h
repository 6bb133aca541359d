#pragma once
// What the pixels that differ have in common, for pictures without a known cause. Internal to
// grade.

#include "scenefile/grade/simulation.h"

#include <string>

namespace scenefile {

/// The term, light or shape that nearly all pixels that differ show, and few of those that are
/// right, in words; empty if there is none. The smallest one.
std::string confined_to(const Simulation& sim);

}  // namespace scenefile
