#include "scenefile/grade/claims.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scenefile {

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

std::string evidence_of_one(double left, double before, double exact) {
  return fmt::format(
      "simulating this mistake reduces the mean difference from {:.3f}/255 to {:.3f}/255 "
      "(not counting edges and rounding) and reproduces {} of the differing pixels",
      before, left, percent(exact));
}

std::string evidence_of_several(double together, double without) {
  return fmt::format("together they explain {} of the difference; without this one, {}",
                     percent(together), percent(std::max(0.0, without)));
}

std::string evidence_of_share(double explained) {
  return fmt::format("simulating this mistake explains {} of the difference", percent(explained));
}

void add_alternatives(Claim& claim, const std::vector<std::string>& others) {
  if (others.empty()) {
    return;
  }
  claim.alternatives = {claim.what};
  claim.alternatives.insert(claim.alternatives.end(), others.begin(), others.end());
  claim.what =
      fmt::format("{}: these give the same picture", fmt::join(claim.alternatives, "; or "));
}

}  // namespace scenefile
