#include "scenefile/import/codes.h"

namespace scenefile {

std::span<const Code* const> import_codes() {
  static constexpr const Code* codes[] = {
      &import_added,       &import_left_out,    &import_limit, &import_missing_file,
      &import_not_a_model, &import_unsupported, &import_value};
  return codes;
}

}  // namespace scenefile
