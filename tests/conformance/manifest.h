#pragma once
// The lists of references: DIR/references.tsv, and the exceptions of this project.

#include "scenefile/trace/render.h"

#include <string>
#include <vector>

namespace scenefile::conformance {

/// One reference picture.
struct Row {
  std::string scene;      ///< relative to the corpus folder
  std::string reference;  ///< likewise
  Mode mode = Mode::ray;
  Features features;
};

/// Reads tab-separated `scene reference mode features` with a header line. `error` says what is
/// wrong with the file; empty if it is valid.
std::vector<Row> read_references(const std::string& path, std::string& error);

/// A picture that cannot reach the threshold, and the reason.
struct Exception {
  std::string reference;  ///< a suffix of the reference; the first match counts
  double floor_db = 0;    ///< must still be reached
  std::string reason;
};

/// Reads tab-separated `reference floor reason`; lines that begin with # are comments.
std::vector<Exception> read_exceptions(const std::string& path, std::string& error);

/// The exception for a reference, or null.
const Exception* find_exception(const std::vector<Exception>& all, const std::string& reference);

}  // namespace scenefile::conformance
