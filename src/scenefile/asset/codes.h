#pragma once
// Every kind of finding about textures and meshes.

#include "scenefile/base/diagnostics.h"

#include <span>

namespace scenefile {

inline constexpr Code texture_missing{
    "texture.missing", Severity::warning, "a texture file cannot be read",
    "The object is shaded with its diffuse color instead. Paths are looked up next to the scene, "
    "in the folders image, images, texture, textures next to it and its parent, and in each "
    "--asset-root. Case is ignored only if there is no exact match."};

inline constexpr Code texture_undecodable{
    "texture.undecodable", Severity::warning, "a texture file is not an image, or is damaged",
    "The object is shaded with its diffuse color instead. PNG, JPEG, GIF, TGA and uncompressed BMP "
    "are read, whatever the extension. A file that is truncated or fails its checksums is not "
    "used: open it in an image editor and save it again as PNG."};

inline constexpr Code texture_limit{
    "texture.limit", Severity::warning, "a texture is larger than the limits allow",
    "The object is shaded with its diffuse color instead. The limits keep a small file that "
    "unpacks to a huge image from using up memory. Make the image smaller, or raise the limit.",
    CodeKind::limit};

inline constexpr Code mesh_missing{
    "mesh.missing",
    Severity::error,
    "a mesh file cannot be read",
    "Paths are looked up next to the scene, in the folders mesh, meshes, model, models next to it "
    "and its parent, and in each --asset-root. With --allow-missing the scene is drawn without it.",
    CodeKind::plain,
    Severity::warning};

inline constexpr Code mesh_unusable{
    "mesh.unusable",
    Severity::error,
    "a mesh file has errors",
    "The findings above, in the mesh file itself, say what is wrong and where. With "
    "--allow-missing the scene is drawn without the mesh.",
    CodeKind::plain,
    Severity::warning};

inline constexpr Code mesh_not_obj{
    "mesh.not-obj",
    Severity::error,
    "a file is not a Wavefront OBJ file",
    "Meshes are read from the text format of Wavefront: lines that begin with v, vt, vn and f. "
    "Other formats (PLY, STL, FBX, glTF, binary .obj object code) must be converted. A warning "
    "with --allow-missing.",
    CodeKind::plain,
    Severity::warning};

inline constexpr Code mesh_number{"mesh.number",
                                  Severity::error,
                                  "a coordinate is missing or is not a finite number",
                                  "v and vn need three numbers, vt one to three. nan and inf are "
                                  "not numbers that can be drawn. A warning with --allow-missing.",
                                  CodeKind::plain,
                                  Severity::warning};

inline constexpr Code mesh_index{
    "mesh.index",
    Severity::error,
    "a face names a vertex, uv or normal that does not exist",
    "The corners of a face are written v, v/vt, v//vn or v/vt/vn, where each is the number of a "
    "line of that kind, counted from 1, or from the end when negative (-1 is the last so far). A "
    "warning with --allow-missing.",
    CodeKind::plain,
    Severity::warning};

inline constexpr Code mesh_limit{
    "mesh.limit",
    Severity::error,
    "a mesh is larger than the limits allow",
    "The number of triangles and their memory are bounded over all meshes of a scene. Reduce the "
    "mesh, or raise the limit. A warning with --allow-missing.",
    CodeKind::limit,
    Severity::warning};

inline constexpr Code mesh_short_face{"mesh.short-face", Severity::warning,
                                      "a face has fewer than three corners",
                                      "It has no area and is left out."};

inline constexpr Code mesh_degenerate{
    "mesh.degenerate", Severity::warning, "triangles without area",
    "Their corners coincide or lie on a line; they are left out. They are invisible, but often a "
    "sign of a bug in the program that wrote the file."};

inline constexpr Code mesh_zero_normal{
    "mesh.zero-normal", Severity::warning, "normals of length zero",
    "They have no direction. Triangles that use them are shaded flat."};

inline constexpr Code mesh_unknown_keyword{
    "mesh.unknown-keyword", Severity::warning, "a line of a mesh file is not understood",
    "Polygons are read (v, vt, vn, f); groups, materials, lines and points are skipped silently. "
    "Free-form curves and surfaces are not drawn. Reported once for each keyword."};

inline constexpr Code mesh_empty{"mesh.empty", Severity::warning, "a mesh has nothing to draw",
                                 "The file has no face with an area, so the object is invisible."};

/// All of the above.
std::span<const Code* const> asset_codes();

}  // namespace scenefile
