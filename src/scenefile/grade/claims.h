#pragma once
// Texts that both searches for causes share: claims, and descriptions of evidence. Internal to
// grade.

#include "scenefile/grade/causes.h"

#include <string>
#include <vector>

namespace scenefile {

/// A share from 0 to 1 in whole percent.
std::string percent(double share);

/// Evidence for one simulated mistake: the mean difference with and without it, in 1/255, and the
/// share of the differing pixels that it reproduces.
std::string evidence_of_one(double left, double before, double exact);
/// The shares of the difference that several mistakes explain together, and without one of them.
std::string evidence_of_several(double together, double without);
/// The share of the difference that a simulated mistake explains.
std::string evidence_of_share(double explained);

/// Makes the claim name other mistakes, too, that give the same picture. `others`: their words.
void add_alternatives(Claim& claim, const std::vector<std::string>& others);

}  // namespace scenefile
