#pragma once

#include "run_row.h"

#include <string>
#include <vector>

namespace scenefile::conformance {

/// Writes FOLDER/index.html with our picture, the reference and the difference (times 8) side by
/// side, worst first, and the pictures themselves. Returns an error text; empty on success.
std::string write_page(const std::string& folder, const std::vector<RowResult>& results,
                       const std::vector<Exception>& exceptions);

}  // namespace scenefile::conformance
