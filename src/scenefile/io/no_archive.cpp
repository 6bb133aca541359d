// Archives in builds without libarchive.

#include "scenefile/io/archive.h"

namespace scenefile {

std::string visit_archive(const std::string&, ArchiveBudget&, const VisitEntry&,
                          const VisitFolder&) {
  return "this build of the program does not read archives";
}

std::string visit_archive_bytes(std::string_view, ArchiveBudget& budget, const VisitEntry& visit,
                                const VisitFolder&) {
  return visit_archive({}, budget, visit);
}

}  // namespace scenefile
