#pragma once
// What is compared with what: DIR/references.tsv and the exceptions of this project.

#include "scenefile/trace/render.h"

#include <string>
#include <vector>

namespace scenefile::conformance {

/// One reference picture.
struct Row {
  std::string scene;      ///< path below the corpus folder
  std::string reference;  ///< likewise
  Mode mode = Mode::ray;
  Features features;
};

/// Reads `scene reference mode features`, tab-separated, with a heading line. `error` says what is
/// wrong with the file, empty when nothing is.
std::vector<Row> read_references(const std::string& path, std::string& error);

/// A picture that cannot reach the threshold, and why.
struct Exception {
  std::string reference;  ///< ends so; the first one that fits counts
  double floor_db = 0;    ///< must still be reached
  std::string reason;
};

/// Reads `reference floor reason`, tab-separated; lines that begin with # are comments.
std::vector<Exception> read_exceptions(const std::string& path, std::string& error);

/// The exception of a reference, null when there is none.
const Exception* find_exception(const std::vector<Exception>& all, const std::string& reference);

}  // namespace scenefile::conformance
