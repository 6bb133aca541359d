#pragma once
// Reads the text of a scene file into a Scene. XML, JSON and their dialects are only known here:
// the Scene does not show whether its file used `focus` or `v1`.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/scene/scene.h"

#include <string_view>

namespace scenefile {

struct ReadOptions {
  /// Do what the course's programs did where the format's documentation says otherwise, each with a
  /// warning: every object of a transblock counts, transforms after an object count, and of a
  /// malformed number its numeric prefix is used.
  bool compat_course = false;
  Limits limits;
};

/// Reads the text of a scene file (UTF-8, or as declared by an XML declaration or byte order mark).
/// The first character that is not white space decides the syntax: `<` is XML, `{` or `[` is JSON.
/// Opens no other file. Always returns a scene; after errors it is `incomplete`, and only good for
/// check(), which finds further errors. Codes: format/codes.h.
Scene read_scene(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace scenefile
