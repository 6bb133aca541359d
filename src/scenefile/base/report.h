#pragma once
// Diagnostics as human-readable text.

#include "scenefile/base/diagnostics.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

struct ReportStyle {
  bool color = false;   ///< ANSI colors
  bool excerpt = true;  ///< show the line of the file, with a caret under the place
  bool notes = true;    ///< show notes too
};

/// All findings in order: first those about the scene file by line and column, then those about
/// other files and those without a place, in the order in which they were reported.
std::vector<const Diagnostic*> by_place(const Diagnostics& diagnostics);

/// All findings by_place(), each as
///
///     chess.xml:41:9: error: unknown element <difuse> in primitive; did you mean <diffuse>?
///     [xml.unknown-element]
///        41 |         <difuse r="0.8" g="0.6" b="0.6"/>
///           |         ^
///
/// `file` is the name of the scene, `text` its bytes for the excerpts (at most 80 characters of a
/// line, escaped). Notes of a finding follow its first line, indented. Findings about other files
/// have no excerpt. Ends with how many of each code were not shown.
std::string report_text(const Diagnostics& diagnostics, std::string_view file,
                        std::string_view text, const ReportStyle& style);

/// "chess.xml: 2 errors, 1 warning", or "chess.xml: fine"; notes do not count.
std::string verdict_text(const Diagnostics& diagnostics, std::string_view file);

}  // namespace scenefile
