#include "scenefile/base/ascii.h"
#include "scenefile/base/text.h"
#include "scenefile/io/archive.h"

#include <array>

namespace scenefile {

namespace {

// The length of the ending of an archive's name; 0 if it has none.
std::size_t ending_length(std::string_view name) {
  static constexpr std::array<std::string_view, 4> endings{".zip", ".tar", ".tar.gz", ".tgz"};
  const std::string plain = lower_case(name);
  for (const std::string_view ending : endings) {
    if (plain.size() > ending.size() && plain.ends_with(ending)) {
      return ending.size();
    }
  }
  return 0;
}

}  // namespace

bool is_archive_name(std::string_view name) {
  return ending_length(name) != 0;
}

std::string_view without_archive_ending(std::string_view name) {
  return name.substr(0, name.size() - ending_length(name));
}

}  // namespace scenefile
