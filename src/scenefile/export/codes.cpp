#include "scenefile/export/codes.h"

namespace scenefile {

std::span<const Code* const> export_codes() {
  static constexpr const Code* codes[] = {&pov_approximate, &pov_lost};
  return codes;
}

}  // namespace scenefile
