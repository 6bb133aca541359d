#pragma once
// The GPU resources of a drawing. Internal to view.

#include "scenefile/base/shape_traits.h"
#include "scenefile/view/expand.h"
#include "scenefile/view/gl_objects.h"
#include "scenefile/view/shadows.h"
#include "scenefile/view/vertices.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// Triangles on the GPU, and their edges once requested.
struct Geometry {
  gl::VertexArray array;
  gl::Buffer vertices;
  gl::Buffer triangles;
  gl::Buffer lines;
  gl::Size triangle_indices = 0;
  gl::Size line_indices = 0;
};

/// Levels of detail of round shapes: segments about the axis.
inline constexpr std::array<int, 9> level_segments{4, 6, 8, 12, 18, 28, 48, 96, 192};

/// A cube has only the first level.
inline constexpr std::size_t levels = level_segments.size();

/// The per-instance input of the vertex shader: the map to the world relative to the eye, row by
/// row; material and number of the object.
struct InstanceRecord {
  std::array<glm::vec4, 3> rows;
  glm::vec4 object{0};
};

struct Drawing::State {
  ExpandedScene scene;
  RenderGlobal global;
  std::vector<RenderLight> lights;
  std::vector<RenderMaterial> materials;
  std::vector<gl::Texture>
      textures;  ///< by RenderTexture::file; empty where the file is not loaded
  gl::Texture material_table;
  gl::Texture emitter_table;
  gl::Buffer instances;
  std::vector<Emitter> emitters;  ///< of the lights that are on in the last draw()
  ShadowMaps shadows;
  std::array<std::array<std::optional<Geometry>, levels>, shape_count> shapes;  ///< by Shape
  std::array<std::optional<Geometry>, shape_count> realtime_shapes;             ///< by Shape
  TessellationParameters realtime_parameters;  ///< of realtime_shapes
  std::vector<Geometry> meshes;
  std::vector<std::vector<std::uint32_t>> mesh_triangles;  ///< indices of `meshes`
};

/// The geometry of an object at a level of detail, created at first use. `with_lines`: with edges.
const Geometry& geometry_of(const gl::Functions& functions, Drawing::State& drawing, Shape shape,
                            std::uint32_t mesh, std::size_t level, bool with_lines);

/// The geometry of a shape in the assignment Realtime, created when the parameters change.
/// `with_lines`: with all edges of its triangles.
const Geometry& realtime_geometry_of(const gl::Functions& functions, Drawing::State& drawing,
                                     Shape shape, const TessellationParameters& parameters,
                                     bool with_lines);

/// Uploads rows of `texels` vec4 each, as a table that the shaders index.
void fill_table(const gl::Functions& functions, gl::Texture& table, int texels,
                const std::vector<glm::vec4>& values);

}  // namespace scenefile
