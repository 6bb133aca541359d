#pragma once
// An explained pixel as an answer: for people and for programs.

#include "app/load.h"
#include "scenefile/explain/remarks.h"

#include <string>
#include <vector>

namespace scenefile::app {

struct ExplainReport {
  PixelRecord pixel;
  std::vector<Remark> remarks;
};

struct ExplainStyle {
  bool color = false;     ///< ANSI colors
  bool swatches = false;  ///< 24-bit colors: a patch of each color beside its numbers
};

/// A tree of what the pixel is made of.
std::string explain_text(const LoadedScene& scene, const ExplainReport& report,
                         const ExplainStyle& style);

/// docs/explain.md describes the document. `report` is null where there is nothing to explain;
/// `error` says why then.
std::string explain_json(const LoadedScene& scene, const RenderOptions& options,
                         const ExplainReport* report, const std::string& error);

}  // namespace scenefile::app
