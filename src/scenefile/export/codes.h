#pragma once
// What writing a scene for another program has to say.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

inline constexpr Code pov_approximate{
    "pov.approximate", Severity::note, "POV-Ray says this in another way",
    "The lighting equations differ: POV-Ray has one highlight strength for all colors, lets the "
    "ambient light of a textured object take the texture's color, fades lights by one power of the "
    "distance, and dims the surface of glass. The picture comes near, not equal."};
inline constexpr Code pov_lost{
    "pov.lost", Severity::warning, "POV-Ray has no word for this",
    "The scene is written without it. Textures of POV-Ray are files that it opens itself, so one "
    "that cannot be found now is replaced by the diffuse color."};

/// All of the above, by name.
std::span<const Code* const> export_codes();

}  // namespace scenefile
