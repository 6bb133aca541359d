#pragma once
// Findings about scenes exported for other programs.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

inline constexpr Code export_approximate{
    "export.approximate", Severity::note, "glTF or OBJ says this in another way",
    "The materials and lights of glTF describe physical surfaces, those of OBJ files know no "
    "mirror colors. The nearest counterpart is written; docs/formats.md lists which. glTF files "
    "hold the scene's own values beside it, so that convert reads them back."};
inline constexpr Code export_lost{
    "export.lost", Severity::warning, "glTF or OBJ has no word for this",
    "The file is written without it. Keep the scene file; it is the only one that says all."};
inline constexpr Code export_size_limit{
    "export.size-limit", Severity::error, "the file would be too large",
    "glTF and OBJ files have no instances of groups: each copy of a template is written out, which "
    "templates of templates make very many, and a GLB file holds 4 GB at most. Convert a part of "
    "the scene.",
    CodeKind::limit};
inline constexpr Code pov_approximate{
    "pov.approximate", Severity::note, "POV-Ray expresses this differently",
    "The lighting equations differ: POV-Ray has one highlight strength for all colors, lets the "
    "ambient light of a textured object take the color of the texture, attenuates lights by a "
    "single power of the distance, and dims the surface of glass. The pictures are similar, not "
    "equal."};
inline constexpr Code pov_lost{
    "pov.lost", Severity::warning, "POV-Ray cannot express this",
    "The scene is written without it. POV-Ray opens texture files itself, so a texture that cannot "
    "be found now is replaced by the diffuse color."};

/// All of the above, by name.
std::span<const Code* const> export_codes();

}  // namespace scenefile
