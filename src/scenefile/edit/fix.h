#pragma once
// Writes into a scene file what its findings suggest: "did you mean <diffuse>?".

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/location.h"
#include "scenefile/edit/text_edit.h"
#include "scenefile/format/read_scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// The change that writes finding.correction into the text of the file, with the escapes and quotes
/// of its syntax. A misspelled element changes its closing tag, too. nullopt if the finding
/// suggests nothing, is about another file, or is not about this text. `bytes` are those of the
/// file, in any encoding but UTF-16.
std::optional<Edit> fix(std::string_view bytes, const Diagnostic& finding);

/// A change by places instead of offsets: `text` replaces the range [from, to).
struct Replacement {
  Location from;
  Location to;
  std::string text;  ///< UTF-8
};

/// For each finding the changes of fix(), with their places; empty if it has none.
std::vector<std::vector<Replacement>> replacements(std::string_view bytes,
                                                   const std::vector<const Diagnostic*>& findings);

/// A text after its certain mistakes were fixed.
struct FixedText {
  std::string text;
  std::vector<Diagnostic> made;  ///< the findings that are fixed; their places are in the old text
  std::string refused;  ///< why certain corrections cannot be made in this file; else empty
};

/// Fixes what is beyond doubt, again and again until nothing changes, so that fixing the result
/// changes nothing. A correction is certain if only one word is meant, and if reading the text
/// again shows that
/// - the finding is gone, and nothing new was found, except what only a complete scene can show, or
///   what follows a mistake at which reading stopped;
/// - for a warning, the scene is the same; for an error, it differs in no more than the values that
///   were in error.
/// All other bytes and the number of lines stay the same. Takes as long as reading the text several
/// times. Findings of the codes in `ignored` are not fixed.
FixedText fix_text(std::string text, const ReadOptions& options,
                   const std::vector<std::string>& ignored = {});

/// The difference of two texts with equally many lines, in the unified format, with three lines of
/// context. Empty if they are the same. `name` is that of the file.
std::string unified_diff(std::string_view before, std::string_view after, std::string_view name);

}  // namespace scenefile
