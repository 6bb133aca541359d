#pragma once
// Finds the one value of the scene file whose change reproduces the picture: the picture was drawn
// from an edited scene, or a program reads that value wrongly. Internal to grade.

#include "scenefile/grade/simulation.h"

#include <optional>

namespace scenefile {

/// Adds the edited scene to the list and returns its score, if drawing it reproduces the picture:
/// alone, beside some of the combinations in `beside`, or beside another mistake.
std::optional<Tried> find_edited_scene(Simulation& sim, const std::vector<Combination>& beside);

/// The mistakes together with an edited scene that explains the remaining difference, if there is
/// one.
std::optional<Tried> find_edit_beside(Simulation& sim, const Combination& mistakes);

}  // namespace scenefile
