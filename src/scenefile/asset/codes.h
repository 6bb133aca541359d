#pragma once
// Every kind of finding about textures and meshes.

#include "scenefile/base/code.h"

namespace scenefile {

inline constexpr Code asset_codes[] = {
    {"texture.missing", Severity::warning, "a texture file cannot be read",
     "The object is shaded with its diffuse color instead. Paths are looked up in the scene's "
     "folder, in folders such as image and textures beside that folder, and in each --asset-root. "
     "Case is ignored only if there is no exact match."},

    {"texture.undecodable", Severity::warning, "a texture file is not an image, or is damaged",
     "The object is shaded with its diffuse color instead. PNG, JPEG, GIF, TGA and uncompressed "
     "BMP are read, whatever the extension. A file that is truncated or fails its checksums is not "
     "used: open it in an image editor and save it again as PNG."},

    {"texture.limit", Severity::warning, "a texture is larger than the limits allow",
     "The object is shaded with its diffuse color instead. The limits keep a small file that "
     "unpacks to a huge image from using up memory. Make the image smaller, or raise the limit.",
     CodeKind::limit},

    {"mesh.missing", Severity::error, "a mesh file cannot be read",
     "Paths are looked up in the scene's folder, in folders such as mesh and models beside that "
     "folder, and in each --asset-root. With --allow-missing the scene is drawn without "
     "it.",
     CodeKind::plain, Severity::warning},

    {"mesh.unusable", Severity::error, "a mesh file has errors",
     "The findings above, in the mesh file itself, say what is wrong and where. With "
     "--allow-missing the scene is drawn without the mesh.",
     CodeKind::plain, Severity::warning},

    {"mesh.not-obj", Severity::error, "a file is not a Wavefront OBJ file",
     "Meshes are read from the text format of Wavefront: lines that begin with v, vt, vn and f. "
     "Other formats (PLY, STL, FBX, glTF, binary .obj object code) must be converted. A warning "
     "with --allow-missing.",
     CodeKind::plain, Severity::warning},

    {"mesh.number", Severity::error, "a coordinate is missing or is not a finite number",
     "v and vn need three numbers, vt one to three. nan and inf are not numbers that can be drawn. "
     "A warning with --allow-missing.",
     CodeKind::plain, Severity::warning},

    {"mesh.index", Severity::error, "a face names a vertex, uv or normal that does not exist",
     "The corners of a face are written v, v/vt, v//vn or v/vt/vn, where each is the number of a "
     "line of that kind, counted from 1, or from the end when negative (-1 is the last so far). If "
     "only normals are missing, a warning: their triangles are shaded flat. Also a warning with "
     "--allow-missing.",
     CodeKind::plain, Severity::warning},

    {"mesh.limit", Severity::error, "a mesh is larger than the limits allow",
     "The number of triangles and their memory are bounded over all meshes of a scene. Reduce the "
     "mesh, or raise the limit. A warning with --allow-missing.",
     CodeKind::limit, Severity::warning},

    {"mesh.short-face", Severity::warning, "a face has fewer than three corners",
     "It has no area and is left out."},

    {"mesh.degenerate", Severity::warning, "triangles without area",
     "Their corners coincide or lie on a line; they are left out. They are invisible, but often a "
     "sign of a bug in the program that wrote the file."},

    {"mesh.zero-normal", Severity::warning, "normals of length zero",
     "They have no direction. Triangles that use them are shaded flat."},

    {"mesh.unknown-keyword", Severity::warning, "a line of a mesh file is not understood",
     "Polygons are read (v, vt, vn, f); groups, materials, lines and points are skipped silently. "
     "Free-form curves and surfaces are not drawn. Reported once for each keyword."},

    {"mesh.empty", Severity::warning, "a mesh has nothing to draw",
     "The file has no face with an area, so the object is invisible."},

    {"mtl.missing", Severity::warning, "a material library of a mesh cannot be read",
     "The faces have the material of their object instead. An OBJ file names its libraries after "
     "mtllib, relative to its own folder; the first that can be read counts. Materials are read in "
     "scenes without lights, and for the path tracer."},

    {"mtl.no-material", Severity::warning, "a material library without a material",
     "Each material begins with a line newmtl NAME. Without one, the faces have the material of "
     "their object. The file may be empty, or in another format."},

    {"mtl.unknown-material", Severity::warning, "a face has a material that no library defines",
     "Its faces have the material of their object instead; the course's program may crash. The "
     "name after usemtl must be that after newmtl, with the same case. Reported once for each "
     "name."},

    {"mtl.duplicate", Severity::warning, "two materials with the same name",
     "The first one counts, as in the course's program. Rename or remove the other."},

    {"mtl.before-newmtl", Severity::warning, "a value before the first material",
     "A value belongs to the last newmtl above it. Values before the first one have no effect."},

    {"mtl.unknown-keyword", Severity::warning, "a line of a material library is not understood",
     "The keywords newmtl, Kd, Ks, Ke, Ns, Ni, Tf (or Kt), d, Tr, illum, map_Kd, map_Ks and map_Ke "
     "are read; Ka and other values of the format are skipped silently. Case matters. Reported "
     "once for each keyword."},

    {"mtl.value", Severity::warning, "a value of a material cannot be read",
     "It keeps its default, as if the line were missing. Colors are three numbers, r g b, with "
     "decimal points."},

    {"mtl.range", Severity::warning, "a value of a material is out of range",
     "Colors and Ns are not negative, Ni is above 0, d and Tr are between 0 and 1. The nearest "
     "valid value is used; for Ni its default."},

    {"mtl.limit", Severity::warning, "material libraries are larger than the limits allow",
     "Materials count toward the limit for the memory of all meshes. Faces whose material is left "
     "out have the material of their object. Reduce the library, or raise the limit.",
     CodeKind::limit},

    {"mtl.energy", Severity::note, "a material reflects more light than it receives",
     "Where Kd + Ks is above 1 in a channel, each reflection adds energy, so the picture is too "
     "bright. It is drawn as written, as in the course's program. Scale Kd and Ks down so that "
     "their sum is at most 1."},

    {"mtl.illum", Severity::note, "an illumination model that is drawn as another one",
     "illum 5 is a mirror and illum 7 is refraction with Fresnel reflection, as in the assignment; "
     "all others are drawn from Kd and Ks alone."},

    {"mtl.mirror-ior", Severity::note, "a mirror without an index of refraction",
     "In the MTL format, illum 5 is a mirror with Fresnel reflection, and with the default Ni of 1 "
     "it reflects nothing. In the assignment, and here, it reflects all light, times Ks."},

    {"mtl.opacity", Severity::note, "transparency that is not drawn",
     "d and Tr have no effect on the picture. Glass is illum 7, with Ni as its index of "
     "refraction."},

    {"mtl.map-option", Severity::note, "an option of a texture that is not applied",
     "Options between map_Kd and the file name move, scale or recolor the texture. The texture is "
     "drawn by the uvs of the mesh alone."},

    {"mtl.leading-point", Severity::note, "a number that starts with a point",
     "tinyobjloader 1.1, which the course's path tracer contains, reads .5 as 0. Here it is 0.5. "
     "Reported once for each library."},
};

template <CodeName name>
constexpr const Code& operator""_code() requires(code_index(asset_codes, name) <
                                                 std::size(asset_codes)) {
  constexpr std::size_t index = code_index(asset_codes, name);
  return asset_codes[index];
}

}  // namespace scenefile
