#pragma once

#include "manifest.h"
#include "scenefile/asset/compare_images.h"

#include <string>

namespace scenefile::conformance {

/// A rendered and compared row.
struct RowResult {
  Row row;
  std::string error;  ///< an error text if there is no picture
  Texture ours;
  Texture theirs;
  ImageDifference difference;
  double cpu_seconds = 0;  ///< of rendering
};

/// Renders a row of the corpus at the size of its reference, with the course profile.
RowResult run_row(const std::string& corpus, const Row& row);

}  // namespace scenefile::conformance
