#pragma once
// Archives: ZIP, and tar, also compressed with gzip. Nothing is unpacked to the disk.

#include "scenefile/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace scenefile {

/// Whether the name ends like that of an archive: .zip, .tar, .tar.gz or .tgz.
bool is_archive_name(std::string_view name);

/// The name without that ending.
std::string_view without_archive_ending(std::string_view name);

/// An entry of an archive, except a folder.
struct ArchiveEntry {
  std::string path;      ///< names separated by slashes, in UTF-8 if the archive says so
  std::string problem;   ///< why it is not read, as a clause; empty: it is a regular file
  bool outside = false;  ///< its path leads out of the archive, which is a problem
};

/// What is left of the bounds. Archives in archives share those of the outermost.
struct ArchiveBudget {
  std::uint64_t entries = 20'000;
  /// Uncompressed: of the entries that are read, and in a tar of everything up to the last one.
  std::uint64_t bytes = std::uint64_t{1} << 30;
};

/// Reads the entry into memory; fails if it is larger than `max_bytes` (ErrorKind::limit), damaged,
/// or has a `problem`.
using ReadEntry = std::function<Result<std::string>(std::uint64_t max_bytes)>;

/// Called for each entry, except junk (is_junk_name()), in the order of the archive. If a path
/// occurs twice, the later entry is the current one. `read` is only valid during the call.
using VisitEntry = std::function<void(const ArchiveEntry& entry, const ReadEntry& read)>;

/// Called for the path of each folder that is an entry or contains one, also junk, unless the
/// folder is junk or not in the archive; possibly more than once.
using VisitFolder = std::function<void(std::string_view path)>;

/// Visits the entries of an archive: a regular file of at most budget.bytes, not a link. Returns
/// why not all entries were visited, as a clause; empty if all were. Links, devices, encrypted
/// entries, and paths that lead out of the archive have a `problem`.
std::string visit_archive(const std::string& path, ArchiveBudget& budget, const VisitEntry& visit,
                          const VisitFolder& visit_folder = {});

/// The same for an archive in memory.
std::string visit_archive_bytes(std::string_view bytes, ArchiveBudget& budget,
                                const VisitEntry& visit, const VisitFolder& visit_folder = {});

}  // namespace scenefile
