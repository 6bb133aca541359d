#pragma once
// Findings about files of other programs that are read as scenes.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

inline constexpr Code import_added{
    "import.added", Severity::note, "a camera or light was added",
    "The file has none, and without them nothing would be seen. Change them in the scene."};
inline constexpr Code import_left_out{
    "import.left-out", Severity::warning, "a part of the file is left out",
    "Scenes hold triangles, Phong materials, pictures on surfaces, lights and a camera. "
    "Animations, "
    "skins, points, lines, normal maps and what else a model may have has no counterpart."};
inline constexpr Code import_limit{
    "import.limit", Severity::error, "the model is larger than the limits allow",
    "The limits keep a mistaken or hostile file from taking all memory; --limit raises them.",
    CodeKind::limit};
inline constexpr Code import_missing_file{
    "import.missing-file",
    Severity::warning,
    "a file that the model names cannot be used",
    "Materials and pictures lie beside the model or in the folders that docs/assets.md lists; "
    "--asset-root names another. A picture that is missing leaves the color of the material. A "
    "model whose geometry is missing is an error.",
    CodeKind::plain,
    Severity::error};
inline constexpr Code import_not_a_model{
    "import.not-a-model", Severity::error, "the file is not a glTF or OBJ file",
    "It is cut, damaged, or of another kind. Export it again, as glTF 2.0 (.glb or .gltf) or "
    "Wavefront OBJ (.obj)."};
inline constexpr Code import_unsupported{
    "import.unsupported", Severity::error, "the model needs what is not read here",
    "glTF 2.0 is read without compression (Draco, meshopt, Basis) and without sparse data. Export "
    "the model again without it."};
inline constexpr Code import_value{
    "import.value", Severity::error, "a value of the model is wrong",
    "A number is missing, out of its range, or leads outside of the file. The program that wrote "
    "the model has a fault, or the file is damaged; the Khronos glTF validator says more."};

/// All of the above, by name.
std::span<const Code* const> import_codes();

}  // namespace scenefile
