#pragma once
// Archives for tests.

#include <string>
#include <string_view>
#include <vector>

namespace scenefile::testing_support {

struct WrittenEntry {
  std::string path;
  std::string bytes = "x";
  enum class Kind { file, folder, symbolic_link, hard_link, device } kind = Kind::file;
};

/// The bytes of an archive. The format follows from the ending of `name`: .zip, .tar, .tar.gz or
/// .tgz. `password`: encrypts a ZIP, unless it is empty; `stored`: without compression. Links
/// lead to their `bytes`.
std::string write_archive(std::string_view name, const std::vector<WrittenEntry>& entries,
                          const std::string& password = {}, bool stored = false);

}  // namespace scenefile::testing_support
