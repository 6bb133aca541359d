// Feeds bytes to visit_archive_bytes(), with bounds so low that small inputs exceed them.

#include "scenefile/io/archive.h"

#include "law.h"
#include "target.h"

#include <string>
#include <string_view>

namespace {

using namespace scenefile;
using fuzz::require;

void judge(std::string_view bytes, const ArchiveBudget& all, std::uint64_t max_bytes,
           bool read_all) {
  ArchiveBudget budget = all;
  std::uint64_t entries = 0;
  const auto visit_folder = [](std::string_view path) {
    require(!path.empty() && !path.starts_with('/') && !path.ends_with('/'), "folders have names");
    require(("/" + std::string(path) + "/").find("/../") == std::string::npos,
            "no folder is outside");
  };
  const std::string why = visit_archive_bytes(
      bytes, budget,
      [&](const ArchiveEntry& entry, const ReadEntry& read) {
        ++entries;
        require(!entry.problem.empty() || (!entry.path.empty() && !entry.path.starts_with('/')),
                "what is read has a path in the archive");
        require(
            !entry.problem.empty() || ("/" + entry.path + "/").find("/../") == std::string::npos,
            "no path leads out of the archive");
        if (read_all) {
          const Result<std::string> contents = read(max_bytes);
          require(contents ? contents->size() <= max_bytes : !contents.error().text.empty(),
                  "there are bounded contents or a reason");
          require(!contents || entry.problem.empty(), "what has a problem is not read");
        }
      },
      visit_folder);
  require(entries <= all.entries && budget.entries <= all.entries - entries,
          "entries are bounded and counted");
  require(budget.bytes <= all.bytes, "the budget never grows");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  judge(bytes, {.entries = 100, .bytes = 1 << 20}, 1 << 20, true);
  judge(bytes, {.entries = 100, .bytes = 1 << 20}, 1 << 20, false);
  judge(bytes, {.entries = 2, .bytes = 100}, 50, true);
  return 0;
}
