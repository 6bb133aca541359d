#include "scenefile/export/codes.h"

namespace scenefile {

std::span<const Code* const> export_codes() {
  static constexpr const Code* codes[] = {&export_approximate, &export_lost, &export_size_limit,
                                          &pov_approximate, &pov_lost};
  return codes;
}

}  // namespace scenefile
