#include "scenefile/viewer/user_path.h"

#include <fmt/format.h>

namespace scenefile::viewer {

std::string user_path(const char* xdg, const char* home, std::string_view usual,
                      std::string_view name) {
  if (xdg != nullptr && *xdg == '/') {
    return fmt::format("{}/scenefile/{}", xdg, name);
  }
  if (home == nullptr || *home == '\0') {
    return {};
  }
  return fmt::format("{}/{}/scenefile/{}", home, usual, name);
}

}  // namespace scenefile::viewer
