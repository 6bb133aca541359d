#include "scenefile/export/pov_shape.h"

#include "scenefile/export/pov_text.h"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace scenefile {

namespace {

// A flat side: its POV-Ray text, and the matrix that maps the image (u along x, v along y) to it,
// by the texture coordinates of docs/rendering.md.
struct FlatSide {
  std::string_view surface;
  std::string_view mapping;
};

constexpr std::string_view on_top = "matrix <1, 0, 0, 0, 0, -1, 0, 1, 0, -.5, 0, .5>";
constexpr std::string_view below = "matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, -.5, 0, -.5>";

constexpr std::array<FlatSide, 6> cube_sides{{
    {"polygon { 5, <-.5,-.5,.5> <.5,-.5,.5> <.5,.5,.5> <-.5,.5,.5> <-.5,-.5,.5>",
     "translate <-.5, -.5, 0>"},
    {"polygon { 5, <-.5,-.5,-.5> <.5,-.5,-.5> <.5,.5,-.5> <-.5,.5,-.5> <-.5,-.5,-.5>",
     "matrix <-1, 0, 0, 0, 1, 0, 0, 0, 1, .5, -.5, 0>"},
    {"polygon { 5, <.5,-.5,-.5> <.5,-.5,.5> <.5,.5,.5> <.5,.5,-.5> <.5,-.5,-.5>",
     "matrix <0, 0, -1, 0, 1, 0, 1, 0, 0, 0, -.5, .5>"},
    {"polygon { 5, <-.5,-.5,-.5> <-.5,-.5,.5> <-.5,.5,.5> <-.5,.5,-.5> <-.5,-.5,-.5>",
     "matrix <0, 0, 1, 0, 1, 0, 1, 0, 0, 0, -.5, -.5>"},
    {"polygon { 5, <-.5,.5,-.5> <.5,.5,-.5> <.5,.5,.5> <-.5,.5,.5> <-.5,.5,-.5>", on_top},
    {"polygon { 5, <-.5,-.5,-.5> <.5,-.5,-.5> <.5,-.5,.5> <-.5,-.5,.5> <-.5,-.5,-.5>", below},
}};

// POV-Ray's warps measure the angle in the opposite direction, from the opposite side.
constexpr std::string_view around_sphere = "warp { spherical } scale <1, 1, -1>";
constexpr std::string_view around_axis = "warp { cylindrical } translate -.5*y scale <1, 1, -1>";

std::string part(std::string_view surface, const PovMaterial& m, std::string_view mapping) {
  return fmt::format("{} {} }}\n", surface, pov_texture(m, mapping));
}

std::string sides(const PovMaterial& m) {
  std::string text = "union {\n";
  for (const FlatSide& side : cube_sides) {
    text += part(side.surface, m, side.mapping);
  }
  return text;
}

// With a texture, each side of a shape needs a separate mapping.
std::string textured(Shape shape, const PovMaterial& m) {
  switch (shape) {
    case Shape::cube:
      return sides(m);
    case Shape::cone:
      return fmt::format("union {{\n{}{}", part("cone { -.5*y, .5, .5*y, 0 open", m, around_axis),
                         part("disc { -.5*y, -y, .5", m, below));
    case Shape::cylinder:
      return fmt::format(
          "union {{\n{}{}{}", part("cylinder { -.5*y, .5*y, .5 open", m, around_axis),
          part("disc { .5*y, y, .5", m, on_top), part("disc { -.5*y, -y, .5", m, below));
    case Shape::sphere:
      return fmt::format("sphere {{ 0, .5 {}", pov_texture(m, around_sphere));
    case Shape::mesh:
      break;
  }
  return {};
}

std::string_view plain(Shape shape) {
  switch (shape) {
    case Shape::cube:
      return "box { -.5, .5";
    case Shape::cone:
      return "cone { -.5*y, .5, .5*y, 0";
    case Shape::cylinder:
      return "cylinder { -.5*y, .5*y, .5";
    case Shape::sphere:
      return "sphere { 0, .5";
    case Shape::mesh:
      break;
  }
  return {};
}

template <typename Vectors, typename Write>
void list(std::string& text, std::string_view name, const Vectors& vectors, const Write& write) {
  text += fmt::format("{} {{ {}\n", name, vectors.size());
  for (const auto& v : vectors) {
    text += fmt::format(", {}\n", write(v));
  }
  text += "}\n";
}

std::string triple(const std::array<std::uint32_t, 3>& t) {
  return fmt::format("<{}, {}, {}>", t[0], t[1], t[2]);
}

bool for_all(const std::vector<std::array<std::uint32_t, 3>>& indices) {
  for (const auto& t : indices) {
    if (t[0] == mesh_no_index) {
      return false;
    }
  }
  return !indices.empty();
}

}  // namespace

std::string pov_primitive(Shape shape, const PovMaterial& m, std::string_view mesh_name,
                          std::string_view placing) {
  std::string text;
  if (shape == Shape::mesh) {
    text = fmt::format("object {{ {} uv_mapping {}", mesh_name, pov_texture(m, ""));
  } else if (m.textured()) {
    text = textured(shape, m);
  } else {
    text = fmt::format("{} {}", plain(shape), pov_texture(m, ""));
  }
  return fmt::format("{}{} {} }}\n", text, pov_interior(m), placing);
}

std::string pov_mesh(const Mesh& mesh) {
  std::string text = "mesh2 {\n";
  const auto vector = [](const glm::vec3& v) { return pov_vector(v); };
  const bool smooth = for_all(mesh.triangle_normals);
  const bool mapped = for_all(mesh.triangle_uvs);
  list(text, "vertex_vectors", mesh.positions, vector);
  if (smooth) {
    list(text, "normal_vectors", mesh.normals, vector);
  }
  if (mapped) {
    list(text, "uv_vectors", mesh.uvs,
         [](const glm::vec2& uv) { return fmt::format("<{}, {}>", uv.x, uv.y); });
  }
  list(text, "face_indices", mesh.triangles, triple);
  if (smooth) {
    list(text, "normal_indices", mesh.triangle_normals, triple);
  }
  if (mapped) {
    list(text, "uv_indices", mesh.triangle_uvs, triple);
  }
  return text + "inside_vector y }\n";
}

}  // namespace scenefile
