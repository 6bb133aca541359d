#pragma once
// How the picture is drawn, changeable while the window is open: profile, features, and the
// course's projects.

#include "scenefile/viewer/session.h"

#include <array>
#include <string_view>

namespace scenefile::viewer {

/// The profiles; the assignment Realtime is one of them, as on the command line. `paths`: mode
/// path, for which the profile is fine.
enum class DrawnAs : std::uint8_t { fine, course, realtime, paths };

DrawnAs drawn_as(const Session& session);
/// Also sets the features and the depth of the profile.
void draw_as(Session& session, DrawnAs drawn);

/// As a picture from a file was drawn.
void draw_like(Session& session, const PictureFit& fit);

/// By its name (trace/features.h). Shadows and textures are also off if their keys switched them
/// off.
bool has_feature(const Session& session, std::string_view word);
void toggle_feature(Session& session, std::string_view word);

/// Named sets of features: all, none, and the course's projects intersect and
/// illuminate.
inline constexpr std::array<std::string_view, 4> feature_sets{"all", "illuminate", "intersect",
                                                              "none"};
void use_feature_set(Session& session, std::string_view word);
/// Whether the features, and the mode, are those of the set.
bool is_feature_set(const Session& session, std::string_view word);

}  // namespace scenefile::viewer
