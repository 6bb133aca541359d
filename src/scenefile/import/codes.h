#pragma once
// Findings about files of other programs that are read as scenes.

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code import_codes[] = {
    {"import.added", Severity::note, "a camera or light was added",
     "The file has none, and without them nothing would be visible. Change them in the scene."},
    {"import.left-out", Severity::warning, "a part of the file is left out",
     "Scenes have triangles, Phong materials, textures, lights and a camera. Animations, skins, "
     "points, lines, normal maps and other features of models have no equivalent. Emission belongs "
     "to the .mtl files of meshes, and counts only in scenes without lights (docs/path.md): use "
     "the "
     "OBJ file as a mesh to keep it."},
    {"import.limit", Severity::error, "the model is larger than the limits allow",
     "The limits keep a faulty or malicious file from taking all memory; --limit raises them.",
     CodeKind::limit},
    {"import.missing-file", Severity::warning, "a file that the model names cannot be used",
     "Materials and pictures are looked up next to the model and in the folders that "
     "docs/assets.md lists; --asset-root adds another. If a picture is missing, the color of the "
     "material is used. A model whose geometry is missing is an error.",
     CodeKind::plain, Severity::error},
    {"import.not-a-model", Severity::error, "the file is not a glTF or OBJ file",
     "It is truncated, damaged, or in another format. Export it again, as glTF 2.0 (.glb or .gltf) "
     "or Wavefront OBJ (.obj)."},
    {"import.unsupported", Severity::error, "the model needs a feature that is not supported",
     "glTF 2.0 is read without compression (Draco, meshopt, Basis) and without sparse data. Export "
     "the model again without it."},
    {"import.value", Severity::error, "a value of the model is wrong",
     "A number is missing, out of range, or points outside of the file. The program that wrote the "
     "model has a bug, or the file is damaged; the Khronos glTF validator gives details."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(import_codes, name) <
                                                 std::size(import_codes)) {
  constexpr std::size_t index = code_index(import_codes, name);
  return import_codes[index];
}

}  // namespace scenefile
