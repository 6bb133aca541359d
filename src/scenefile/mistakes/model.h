#pragma once
// A model of a student's ray tracer: simple, one ray at a time, and able to simulate every mistake
// in mistakes.h. Computes single pixels; whole pictures are rendered by trace/render.h.

#include "scenefile/asset/load_assets.h"
#include "scenefile/mistakes/mistakes.h"
#include "scenefile/scene/render_scene.h"
#include "scenefile/trace/render.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace scenefile {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A color with its channels clamped to [0, 1].
inline glm::dvec3 clamped(const glm::dvec3& color) {
  return glm::clamp(color, glm::dvec3(0), glm::dvec3(1));
}

/// A shape in the world.
struct ModelPart {
  DAffine world_from_object;
  DAffine object_from_world;
  Shape shape = Shape::cube;
  std::uint32_t mesh = no_index;
  std::uint32_t material = 0;
  std::uint32_t source = 0;
};

/// A bounding volume hierarchy with four children per node, which are tested at once.
struct ModelTree {
  using Four = float __attribute__((vector_size(16)));
  /// A range of `count` indices in `order`; if count is 0, the node `first`.
  struct Child {
    std::uint32_t first;
    std::uint32_t count;
  };
  struct Node {
    Four low[3];  ///< by axis and child; more than `high`: no child
    Four high[3];
    Child children[4];
  };
  std::vector<Node> nodes;  ///< the first is the root
  std::vector<std::uint32_t> order;
};

/// The shapes of a scene without groups, with a hierarchy to find them.
struct ModelShapes {
  std::vector<ModelPart> parts;
  ModelTree tree;
  std::shared_ptr<const std::vector<ModelTree>> mesh_trees;  ///< by mesh
};

/// Scenes with more shapes are not analyzed.
inline constexpr double max_model_parts = 300000;

/// Null if the scene has more shapes than max_model_parts. `same_meshes`: shapes with the same
/// assets, if there are any.
std::shared_ptr<const ModelShapes> flatten(const RenderScene& scene, const Assets& assets,
                                           const ModelShapes* same_meshes = nullptr);

/// What a camera ray hits first.
struct ModelHit {
  double t = 0;
  double stretch = 1;               ///< position in the world = origin + t * this
  const ModelPart* part = nullptr;  ///< null: nothing
  int face = 0;  ///< 0 side, 1 top, 2 bottom; cubes: 1 + 2 * axis + (low ? 1 : 0)
  std::uint32_t triangle = 0;
  double b1 = 0, b2 = 0;
};

struct ModelRay {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};
};

/// A point that another renderer shows: its position in world space, the normal to shade with, and
/// the normal in object space.
struct ShownPoint {
  glm::dvec3 position{0};
  glm::dvec3 normal{0};
  glm::dvec3 object_normal{0};
  std::uint32_t material = 0;
};

/// The normal in object space at a position on a face (ModelHit::face), as long as the gradient of
/// the shape's equation.
glm::dvec3 shape_normal(Shape shape, int face, const glm::dvec3& position, ConeNormalMistake cone,
                        bool caps_down, ShapeMistake mistake);
/// A normal of unit length in object space, in world space; its length is not 1, see
/// keeps_length().
glm::dvec3 transformed_normal(const ModelPart& part, const glm::dvec3& normal,
                              NormalMistake mistake);
/// Whether the mistake is that transformed_normal() is not normalized.
bool keeps_length(NormalMistake mistake);

/// The part of a light that is left at a distance, with the mistake. The coefficients are constant,
/// linear and quadratic.
double faded(const glm::vec3& coefficients, double distance, AttenuationMistake mistake);
/// The part of a spotlight that is left where the direction away from it has this cosine with its
/// axis, with the mistake.
double spot_share(const RenderLight& light, double cosine, SpotMistake mistake);

/// A scene drawn with mistakes. Everything it refers to must outlive it.
class Model {
 public:
  Model(const RenderScene& scene, const ModelShapes& shapes, const Assets& assets,
        const RenderOptions& options, const ModelMistakes& mistakes);

  /// The ray through a position in the picture; u, v and w of the camera need not have unit length.
  ModelRay camera_ray(const glm::dvec2& place, double width, double height) const;
  ModelHit first_hit(const ModelRay& ray) const;
  /// Not clamped. `known`: the hit of the ray, if known.
  glm::dvec3 color(const ModelRay& ray, const ModelHit* known = nullptr) const;
  /// The possible colors of a mirror whose reflected rays may hit the mirror itself: for each of
  /// `patterns`, bit k is set if the ray of bounce k does. Not clamped.
  std::vector<glm::dvec3> self_mirrored(const ModelRay& ray, std::uint32_t patterns) const;
  /// The diffuse and specular light that arrives from each light at the ray's hit.
  std::vector<glm::dvec3> light_shares(const ModelRay& ray) const;
  /// One of several samples of a pixel, which share the samples of the camera's lens.
  struct Sample {
    int index = 0;
    int count = 1;
  };
  /// The color at the center of a pixel, with the camera's lens samples; not clamped.
  glm::dvec3 pixel(const glm::dvec2& place, double width, double height, const ModelHit* known,
                   const Sample& sample) const;
  /// The color of a point that is visible from the camera, computed without tracing rays: no
  /// shadows, textures, reflections or refraction. Not clamped.
  glm::dvec3 lit(const ShownPoint& point) const;
  /// The work done so far, in rays of scenes with few shapes.
  std::uint64_t rays() const { return rays_ + far_steps_ / 8; }

 private:
  struct Surface;
  struct Arrival;
  struct TextureUse;
  bool meet(const ModelPart& part, const ModelRay& ray, double t_min, double t_max, bool shadow,
            ModelHit& hit) const;
  bool search(const ModelRay& ray, double t_min, double t_max, bool shadow,
              const ModelPart* without, ModelHit& hit) const;
  Surface surface(const ModelRay& ray, const ModelHit& hit) const;
  glm::dvec3 texture_or_plain(const Surface& s, int depth, TextureUse& use) const;
  bool arrival(const RenderLight& light, const Surface& s, const glm::dvec2& on_light,
               Arrival& arriving) const;
  bool shadowed(const RenderLight& light, const Surface& s, const Arrival& arriving,
                int depth) const;
  glm::dvec3 surface_color(const Surface& s, const glm::dvec3& to_eye, int depth) const;
  glm::dvec3 lighting(const Surface& s, const glm::dvec3& to_eye, int depth,
                      std::vector<glm::dvec3>* shares) const;
  /// `chain`: the weight of this ray's mirror; only for MirrorMistake::last_weight_only.
  glm::dvec3 trace(const ModelRay& ray, int depth, const ModelHit* known, double t_min,
                   const glm::dvec3& chain) const;
  glm::dvec3 mirrored(const Surface& s, const ModelRay& ray, int depth, glm::dvec3& local) const;
  glm::dvec3 refracted(const Surface& s, const ModelRay& ray, int depth, glm::dvec3& local,
                       glm::dvec3& reflected) const;
  bool counts(const RenderLight& light) const;
  double written_length(const RenderLight& light) const;
  double transparency() const;

  const RenderScene& scene_;
  const ModelShapes& shapes_;
  const Assets& assets_;
  const RenderOptions& options_;
  const ModelMistakes& m_;
  double film_;  // height of the film at distance 1
  mutable std::uint64_t rays_ = 0;
  mutable std::uint64_t far_steps_ =
      0;  // nodes and shapes tested, beyond the first few of each ray
  mutable std::uint32_t self_hits_ = 0;  // the argument of self_mirrored()
};

}  // namespace scenefile
