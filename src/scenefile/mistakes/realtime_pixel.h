#pragma once
// A pixel of the assignment Realtime: the pixels of the frame that it is made of, and the surfaces
// that they show. Semantics: docs/realtime.md.

#include "scenefile/base/realtime.h"
#include "scenefile/trace/explain.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile {

/// A point on a triangle. Corners, position and normals are in world space unless they say object.
struct RealtimeSurface {
  ObjectRef object;
  Shape shape = Shape::cube;
  std::uint32_t mesh = no_index;  ///< into RenderScene::mesh_files, for Shape::mesh
  std::uint32_t triangle = 0;     ///< of the tessellated shape or of the mesh
  std::uint32_t material = 0;     ///< into RenderScene::materials
  Affine world_from_object;
  std::array<glm::dvec3, 3> object_corners{};
  glm::dvec3 object_position{0};
  glm::dvec3 object_normal{0};  ///< interpolated; any length
};

struct RealtimeFramePixel {
  glm::ivec2 at{0};                        ///< row 0 is the lowest
  double weight = 1;                       ///< of its 8-bit color in the picture's pixel
  std::optional<RealtimeSurface> surface;  ///< none: the background
};

/// color = clamped(colors * sum + added), where sum adds weight * 8-bit color of the frame's
/// pixels.
struct RealtimePixel {
  glm::ivec2 frame{0};                     ///< size of the frame
  std::vector<RealtimeFramePixel> shares;  ///< the largest weight first; never empty
  glm::dmat3 colors{1};
  glm::dvec3 added{0};
};

/// The pixel (x, y), row 0 at the top, of a picture of that size. nullopt: the scene has more
/// shapes than max_explained_shapes.
std::optional<RealtimePixel> realtime_pixel(const RenderScene& scene, const Assets& assets,
                                            const RealtimeOptions& panel, const glm::ivec2& size,
                                            const glm::ivec2& pixel);
inline constexpr double max_explained_shapes = 300000;

}  // namespace scenefile
