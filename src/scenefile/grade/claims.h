#pragma once
// Claims that both searches for causes make in the same words, and their evidence as text. Internal
// to the room.

#include "scenefile/grade/causes.h"

#include <optional>
#include <string>

namespace scenefile {

/// A share from 0 to 1 in whole percent.
std::string percent(double share);

/// What one simulated mistake leaves of the mean difference, both in 1/255 of a value, and the
/// share of the differing pixels that it matches.
std::string evidence_of_one(double left, double before, double exact);
/// The shares of the difference that several mistakes explain together, and one of them by itself.
std::string evidence_of_several(double together, double by_itself);
/// The share of the difference that a simulated mistake explains.
std::string evidence_of_share(double explained);

/// A test picture that is black, or of another single color, unlike the reference.
std::optional<Claim> claim_of_one_color(const Texture& reference, const Texture& test);

}  // namespace scenefile
