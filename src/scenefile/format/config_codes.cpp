#include "scenefile/format/config_codes.h"

#include <array>

namespace scenefile {

std::span<const Code* const> config_codes() {
  static constexpr std::array codes{
      &config_syntax,        &config_backslash,   &config_unknown_key,    &config_key_case,
      &config_duplicate_key, &config_missing_key, &config_picture_format, &config_value,
  };
  return codes;
}

}  // namespace scenefile
