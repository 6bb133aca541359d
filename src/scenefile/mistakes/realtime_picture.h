#pragma once
// A model of a student's program for the assignment Realtime: a small software rasterizer that can
// simulate known mistakes. It follows the rules of docs/realtime.md; lighting is shared with
// model.h.

#include "scenefile/base/realtime.h"
#include "scenefile/geometry/mesh.h"
#include "scenefile/mistakes/hypotheses.h"
#include "scenefile/mistakes/model.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace scenefile {

enum class Culling : std::uint8_t { back, none, front };

enum class DepthTest : std::uint8_t {
  less,
  none,      ///< later triangles cover earlier ones
  reversed,  ///< the farthest triangle wins
};

enum class Interpolation : std::uint8_t {
  normals,         ///< lighting per pixel
  flat,            ///< the normal of the triangle
  first_corner,    ///< the normal of the triangle's first corner
  last_corner,     ///< ... of its last corner
  colors,          ///< lighting per vertex
  not_normalized,  ///< normals are not normalized per pixel
};

/// Which triangles have the wrong winding order.
struct InsideOut {
  std::array<bool, shape_count> sides{};  ///< by shape
  std::array<bool, shape_count> caps{};
  friend bool operator==(const InsideOut&, const InsideOut&) = default;
};

/// How a student's shapes differ from those of the assignment.
struct MeshMistakes {
  int quarter_turns = 0;          ///< the first wedge begins at another angle
  bool half_wedge = false;        ///< ... half a wedge farther
  bool clockwise = false;         ///< wedges follow each other toward +z
  bool other_diagonal = false;    ///< quads are split from their upper right to their lower left
  bool seam_missing = false;      ///< the last wedge is not drawn
  bool last_row_missing = false;  ///< the lowest row of quads is not drawn
  bool radius_one = false;        ///< shapes have a radius of 1, not of 0.5
  bool tip_up = false;            ///< the normal at a cone's tip points up
  bool tip_of_first = false;      ///< ... is that of the wedge's first edge
  friend bool operator==(const MeshMistakes&, const MeshMistakes&) = default;
};

enum class FilterBorder : std::uint8_t { wrap, clamp, black, mirror };

/// Any filter of a finished frame: a kernel, then an affine map of each color.
struct FilterSteps {
  int columns = 1;
  int rows = 1;
  std::vector<double> weights{1};  ///< row by row from the bottom; columns * rows
  glm::dvec2 step{1};              ///< distance of samples in texels of the frame
  glm::dvec2 offset{0};            ///< added to the position of all samples, in texels
  FilterBorder border = FilterBorder::wrap;
  glm::dmat3 colors{1};
  glm::dvec3 added{0};
  bool background_left = false;  ///< the background is not filtered
};
FilterSteps steps_of(Filter filter);

/// How a student's frame differs. Sizes in pixels; nullopt: those of the assignment.
struct FrameMistakes {
  std::optional<glm::dvec2> viewport;  ///< size of the viewport, from the lower left
  std::optional<glm::dvec2> frame;     ///< size of the frame, which is scaled to the picture
  std::optional<double> aspect;        ///< of the camera
};

struct RealtimeTrial {
  Trial scene;  ///< with all lights that are drawn
  RealtimeOptions panel;
  std::optional<FilterSteps> filter;  ///< instead of the panel's
  Culling culling = Culling::back;
  DepthTest depth = DepthTest::less;
  Interpolation interpolation = Interpolation::normals;
  std::array<bool, shape_count> interpolated_shapes = [] {
    std::array<bool, shape_count> all{};
    all.fill(true);
    return all;
  }();  ///< that it applies to
  InsideOut inside_out;
  MeshMistakes mesh;
  std::array<std::optional<TessellationParameters>, shape_count>
      tessellation;  ///< by shape; else the panel's
  FrameMistakes frame;
};

/// Whether meshes can have the mistake; others are in the equations of shapes.
bool occurs_in_meshes(ShapeMistake mistake);

/// The shapes of a scene in world space, shared by all its pictures.
struct RealtimeShapes {
  std::vector<ModelPart> parts;
  std::array<double, shape_count> counts{};  ///< by shape
};

/// Searches for causes are limited to scenes with this many shapes.
inline constexpr double max_searched_shapes = 30000;
/// In the order of the file: a group's primitives, then its instances. Null if the scene has more
/// than `most` shapes.
std::shared_ptr<const RealtimeShapes> realtime_shapes(const RenderScene& scene,
                                                      double most = max_searched_shapes);

/// Which triangle each pixel of a frame shows.
struct Visibility {
  static constexpr std::uint32_t nothing = 0xffffffffu;
  struct Triangle {
    std::uint32_t part = 0;
    std::uint32_t index = 0;  ///< in the part's mesh
  };
  int width = 0;  ///< of the frame
  int height = 0;
  int viewport_width = 0;
  int viewport_height = 0;
  double aspect = 1;
  std::vector<std::uint32_t> seen;  ///< into triangles; row 0 is the lowest
  std::vector<Triangle> triangles;
  std::array<Mesh, shape_count> meshes;
  std::shared_ptr<const RealtimeShapes> shapes;
  /// World positions of the corners.
  std::array<glm::dvec3, 3> corners(const Triangle& t, const Assets& assets) const;
  const Mesh& mesh_of(const Triangle& t, const Assets& assets) const;
};

/// Rasterizes the trial's triangles; if `only` is given, at least in that part of the frame, whose
/// row 0 is the lowest.
std::shared_ptr<const Visibility> find_visible(const RealtimeTrial& trial,
                                               std::shared_ptr<const RealtimeShapes> shapes,
                                               const Assets& assets, int width, int height,
                                               const std::optional<PixelRegion>& only = {});

/// The share of a pixel of the frame in a pixel of the picture.
struct FrameShare {
  glm::ivec2 at{0};  ///< row 0 is the lowest; negative: black, beyond the border
  double weight = 0;
};

/// The colors of a picture. All arguments of the constructor must outlive it.
class RealtimePicture {
 public:
  RealtimePicture(const RealtimeTrial& trial, std::shared_ptr<const Visibility> visible,
                  const Assets& assets, int width, int height);

  /// The color of the picture's pixel, row 0 at the top; in [0, 1] unless a filter exceeds that
  /// range; then it must be clamped.
  glm::dvec3 pixel(int x, int y) const;
  /// The pixels of the frame that the picture's pixel is made of, each once. The pixel is
  /// clamped(colors * sum + added) of the filter, where sum adds weight * 8-bit color.
  std::vector<FrameShare> shares(int x, int y) const;
  const FilterSteps& filter() const { return filter_; }
  /// What a pixel of the frame shows, unless it is `nothing`.
  ShownPoint point_at(const glm::ivec2& frame_pixel) const;
  /// The triangle that covers most of the pixel, or `nothing`.
  std::uint32_t triangle_at(int x, int y) const;
  /// The depth of the triangle there, along the view axis.
  double depth_at(int x, int y) const;

 private:
  bool normalizes() const;
  glm::dvec3 frame_color(int x, int y) const;
  glm::dvec3 texel(const glm::ivec2& at) const;
  glm::ivec2 in_frame(int x, int y) const;
  template <typename Add>
  void for_each_share(int x, int y, const Add& add) const;
  glm::dvec2 place_of(int x, int y) const;
  glm::dvec3 weights_at(int x, int y, const std::array<glm::dvec3, 3>& corners,
                        glm::dvec3& position) const;
  glm::dvec3 normal_of(const ModelPart& part, const Mesh& mesh, std::uint32_t index, int corner,
                       glm::dvec3& in_object) const;

  const RealtimeTrial& trial_;
  std::shared_ptr<const Visibility> visible_;
  const Assets& assets_;
  int width_;
  int height_;
  FilterSteps filter_;
  ModelShapes no_shapes_;
  RenderOptions options_;
  std::unique_ptr<Model> model_;
};

}  // namespace scenefile
