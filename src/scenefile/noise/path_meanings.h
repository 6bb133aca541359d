#pragma once
// What the numbers of a fitted picture mean. Internal to noise.

#include "scenefile/noise/picture_readings.h"

#include <optional>
#include <string>
#include <vector>

namespace scenefile {

struct Meaning {
  Cause page = Cause::scattering;
  std::string name;
  std::string what;
};

/// The names and phrases for a model that explains the picture: several if they give the same
/// picture. `whole`: the factor of visible lamps, if known. `general`: set if a free number is not
/// one that a known mistake gives.
std::vector<Meaning> meanings(const PathTruth& truth, const PathModel& m,
                              std::optional<LampFactor> whole, bool& general);

}  // namespace scenefile
