#include "scenefile/view/scene_buffers.h"

#include "scenefile/geometry/realtime_mesh.h"
#include "scenefile/view/codes.h"
#include "scenefile/view/device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace scenefile {

namespace {

const void* byte_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);
}

Geometry make_geometry(const gl::Functions& gl, const DrawVertices& data) {
  Geometry geometry{gl::VertexArray(gl), gl::Buffer(gl), gl::Buffer(gl), {}, 0, 0};
  gl.BindVertexArray(geometry.array.name());
  gl.BindBuffer(gl::ARRAY_BUFFER, geometry.vertices.name());
  gl.BufferData(gl::ARRAY_BUFFER, std::ptrdiff_t(data.vertices.size() * sizeof(DrawVertex)),
                data.vertices.data(), gl::STATIC_DRAW);
  gl.BindBuffer(gl::ELEMENT_ARRAY_BUFFER, geometry.triangles.name());
  gl.BufferData(gl::ELEMENT_ARRAY_BUFFER,
                std::ptrdiff_t(data.triangles.size() * sizeof(std::uint32_t)),
                data.triangles.data(), gl::STATIC_DRAW);
  geometry.triangle_indices = static_cast<gl::Size>(data.triangles.size());
  const struct {
    int size;
    std::size_t offset;
  } attributes[] = {{3, offsetof(DrawVertex, position)},
                    {4, offsetof(DrawVertex, normal)},
                    {2, offsetof(DrawVertex, uv)}};
  for (gl::Name i = 0; i < 3; ++i) {
    gl.EnableVertexAttribArray(i);
    gl.VertexAttribPointer(i, attributes[i].size, gl::FLOAT, 0, sizeof(DrawVertex),
                           byte_offset(attributes[i].offset));
  }
  for (gl::Name i = 3; i < 7; ++i) {
    gl.EnableVertexAttribArray(i);
    gl.VertexAttribDivisor(i, 1);
  }
  return geometry;
}

void add_lines(const gl::Functions& gl, Geometry& geometry,
               const std::vector<std::uint32_t>& lines) {
  geometry.lines = gl::Buffer(gl);
  gl.BindVertexArray(geometry.array.name());
  gl.BindBuffer(gl::ELEMENT_ARRAY_BUFFER, geometry.lines.name());
  gl.BufferData(gl::ELEMENT_ARRAY_BUFFER, std::ptrdiff_t(lines.size() * sizeof(std::uint32_t)),
                lines.data(), gl::STATIC_DRAW);
  geometry.line_indices = static_cast<gl::Size>(lines.size());
}

gl::Texture make_texture(const gl::Functions& gl, const Texture& image) {
  gl::Texture texture(gl);
  gl.BindTexture(gl::TEXTURE_2D, texture.name());
  gl.PixelStorei(gl::UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(gl::TEXTURE_2D, 0, gl::RGB8, image.width, image.height, 0, gl::RGB,
                gl::UNSIGNED_BYTE, image.rgb.data());
  gl.PixelStorei(gl::UNPACK_ALIGNMENT, 4);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MIN_FILTER, gl::LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MAG_FILTER, gl::LINEAR);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_WRAP_S, gl::REPEAT);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_WRAP_T, gl::REPEAT);
  gl.GenerateMipmap(gl::TEXTURE_2D);
  return texture;
}

// The layout of shaders/scene.frag.
std::vector<glm::vec4> material_values(const RenderScene& scene) {
  std::vector<glm::vec4> values;
  const RenderGlobal& global = scene.global;
  for (const RenderMaterial& m : scene.materials) {
    values.emplace_back(global.ambient * m.ambient, m.shininess);
    values.emplace_back(global.diffuse * m.diffuse, m.blend);
    values.emplace_back(global.specular * m.specular, 0);
    values.emplace_back(m.transparent, 0);
    values.emplace_back(m.texture.repeat_u, m.texture.repeat_v, m.bump_map.repeat_u,
                        m.bump_map.repeat_v);
  }
  return values;
}

void report_left_out(const RenderScene& scene, const ExpandedScene& expanded,
                     Diagnostics& diagnostics) {
  if (!expanded.complete) {
    diagnostics.report(
        "gl.copies-left-out"_code, {},
        fmt::format("the scene has {:.4g} objects after instancing, OpenGL draws "
                    "the {} {}; the ray tracer draws them all",
                    count_virtual_primitives(scene), expanded.largest ? "largest" : "first",
                    expanded.objects.size()));
  }
}

void report_not_drawn(const RenderScene& scene, Diagnostics& diagnostics) {
  const auto any = [&](const auto& test) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), test);
  };
  std::vector<std::string> missing;
  if (any([](const RenderMaterial& m) { return m.reflective != glm::vec3(0); })) {
    missing.emplace_back("reflections of mirrors");
  }
  if (any([](const RenderMaterial& m) { return m.transparent != glm::vec3(0) && m.ior != 1; })) {
    missing.emplace_back("light bent by glass");
  }
  if (scene.camera.aperture > 0 && scene.camera.focal_length > 0) {
    missing.emplace_back("the lens of the camera");
  }
  if (!missing.empty()) {
    diagnostics.report(
        "gl.not-drawn"_code, {},
        fmt::format("the scene has features that OpenGL leaves out: {}", fmt::join(missing, ", ")));
  }
}

}  // namespace

void fill_table(const gl::Functions& gl, gl::Texture& table, int texels,
                const std::vector<glm::vec4>& values) {
  const int row = texels * table_width;
  const int rows = std::max(1, (static_cast<int>(values.size()) + row - 1) / row);
  const int width = std::clamp(static_cast<int>(values.size()), 1, row);
  std::vector<glm::vec4> padded = values;
  padded.resize(std::size_t(width) * rows);
  if (!table) {
    table = gl::Texture(gl);
  }
  gl.BindTexture(gl::TEXTURE_2D, table.name());
  gl.TexImage2D(gl::TEXTURE_2D, 0, gl::RGBA32F, width, rows, 0, gl::RGBA, gl::FLOAT, padded.data());
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MIN_FILTER, gl::NEAREST);
  gl.TexParameteri(gl::TEXTURE_2D, gl::TEXTURE_MAG_FILTER, gl::NEAREST);
}

const Geometry& geometry_of(const gl::Functions& gl, Drawing::State& drawing, Shape shape,
                            std::uint32_t mesh, std::size_t level, bool with_lines) {
  if (shape == Shape::mesh) {
    Geometry& geometry = drawing.meshes[mesh];
    if (with_lines && !geometry.lines) {
      add_lines(gl, geometry, edges(drawing.mesh_triangles[mesh]));
    }
    return geometry;
  }
  std::optional<Geometry>& geometry = drawing.shapes[static_cast<std::size_t>(shape)][level];
  if (!geometry || (with_lines && !geometry->lines)) {
    const DrawVertices data = shape_vertices(shape, level_segments[level]);
    geometry = make_geometry(gl, data);
    if (with_lines) {
      add_lines(gl, *geometry, bent_edges(data));
    }
  }
  return *geometry;
}

const Geometry& realtime_geometry_of(const gl::Functions& gl, Drawing::State& drawing, Shape shape,
                                     const TessellationParameters& parameters, bool with_lines) {
  if (drawing.realtime_parameters != parameters) {
    drawing.realtime_shapes = {};
    drawing.realtime_parameters = parameters;
  }
  std::optional<Geometry>& geometry = drawing.realtime_shapes[static_cast<std::size_t>(shape)];
  if (!geometry || (with_lines && !geometry->lines)) {
    const DrawVertices data = mesh_vertices(realtime_mesh(shape, parameters), true);
    geometry = make_geometry(gl, data);
    if (with_lines) {
      add_lines(gl, *geometry, edges(data.triangles));
    }
  }
  return *geometry;
}

Drawing::Drawing(std::unique_ptr<State> state) : state_(std::move(state)) {}
Drawing::Drawing(Drawing&&) noexcept = default;
Drawing& Drawing::operator=(Drawing&&) noexcept = default;
Drawing::~Drawing() = default;

std::span<const DrawnObject> Drawing::objects() const {
  return state_->scene.names;
}

std::span<const Placement> Drawing::placements() const {
  return state_->scene.placements;
}

Drawing upload(GlDevice& device, const RenderScene& scene, const Assets& assets,
               const UploadOptions& options, Diagnostics& diagnostics) {
  const gl::Functions& gl = device.state().gl;
  auto state = std::make_unique<Drawing::State>();
  state->scene = expand(scene, assets, options.max_objects);
  report_left_out(scene, state->scene, diagnostics);
  report_not_drawn(scene, diagnostics);
  state->global = scene.global;
  state->lights = scene.lights;
  state->materials = scene.materials;
  for (const Texture& image : assets.textures) {
    state->textures.push_back(image.empty() ? gl::Texture() : make_texture(gl, image));
  }
  fill_table(gl, state->material_table, material_texels, material_values(scene));
  state->instances = gl::Buffer(gl);
  for (const Mesh& mesh : assets.meshes) {
    DrawVertices data = mesh_vertices(mesh, !options.flat_meshes);
    state->meshes.push_back(make_geometry(gl, data));
    state->mesh_triangles.push_back(std::move(data.triangles));
  }
  return Drawing(std::move(state));
}

}  // namespace scenefile
