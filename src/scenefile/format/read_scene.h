#pragma once
// From the text of a scene file to a Scene. Both syntaxes, XML and JSON, and their dialects end
// here: nothing behind this header knows that `focus` or `v1` existed.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

struct ReadOptions {
  /// Follow what the course's programs did where the format text says otherwise: every object of a
  /// transblock counts, transforms behind an object count, a malformed number is read by its
  /// numeric prefix. Each with a warning.
  bool compat_course = false;
  Limits limits;
};

/// Reads the text of a scene file (UTF-8, or what an XML declaration or byte order mark says).
/// The first character that is not white space decides the syntax: `<` XML, `{` or `[` JSON.
/// Opens no other file. Always returns a scene. After errors it is `incomplete`: good for check(),
/// which finds what else is wrong, and for nothing else.
/// Codes: format/codes.h.
Scene read_scene(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
