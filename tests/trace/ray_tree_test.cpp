// What a wavefront of one lane keeps of its rays is what the reference computes for each ray.

#include "scenefile/trace/ray_tree_recorder.h"
#include "trace/pixel_recorder.h"
#include "trace/random_scene.h"
#include "trace/scalar_tracer.h"

#include <gtest/gtest.h>

#include <string>

namespace scenefile::trace_test {
namespace {

/// Finds the first of some things that differs.
class Difference {
 public:
  template <typename T>
  void compare(const std::string& what, const T& found, const T& expected) {
    if (first_.empty() && !(found == expected)) {
      first_ = what;
    }
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

bool same(const ObjectRef& a, const ObjectRef& b) {
  return a.source == b.source && a.instances == b.instances;
}

bool same(const Ray& a, const Ray& b) {
  return a.origin == b.origin && a.direction == b.direction;
}

void compare_blockers(const LightSample& a, const LightSample& b, Difference& d) {
  d.compare("number of blockers", a.blockers.size(), b.blockers.size());
  for (std::size_t i = 0; i < std::min(a.blockers.size(), b.blockers.size()); ++i) {
    const Blocker& x = a.blockers[i];
    const Blocker& y = b.blockers[i];
    d.compare("blocker: object", same(x.object, y.object), true);
    d.compare("blocker: t", x.t, y.t);
    d.compare("blocker: passes", x.passes, y.passes);
    d.compare("blocker: itself", x.itself, y.itself);
  }
}

void compare_samples(const LightSample& a, const LightSample& b, Difference& d) {
  d.compare("to_light", a.to_light, b.to_light);
  d.compare("distance", a.distance, b.distance);
  d.compare("attenuation", a.attenuation, b.attenuation);
  d.compare("spot_factor", a.spot_factor, b.spot_factor);
  d.compare("color of a light", a.color, b.color);
  d.compare("n_dot_l", a.n_dot_l, b.n_dot_l);
  d.compare("r_dot_v", a.r_dot_v, b.r_dot_v);
  d.compare("diffuse", a.diffuse, b.diffuse);
  d.compare("specular", a.specular, b.specular);
  d.compare("shadow_ray", a.shadow_ray, b.shadow_ray);
  d.compare("visibility", a.visibility, b.visibility);
  d.compare("contribution", a.contribution, b.contribution);
  compare_blockers(a, b, d);
}

void compare_lights(const RayRecord& a, const RayRecord& b, Difference& d) {
  d.compare("number of lights", a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < std::min(a.lights.size(), b.lights.size()); ++i) {
    const LightRecord& x = a.lights[i];
    const LightRecord& y = b.lights[i];
    d.compare("light", x.light, y.light);
    d.compare("unlit", x.unlit, y.unlit);
    d.compare("taken", x.taken, y.taken);
    d.compare("contribution of a light", x.contribution, y.contribution);
    d.compare("number of samples", x.samples.size(), y.samples.size());
    for (std::size_t k = 0; k < std::min(x.samples.size(), y.samples.size()); ++k) {
      compare_samples(x.samples[k], y.samples[k], d);
    }
  }
}

void compare_textures(const TextureRecord& a, const TextureRecord& b, Difference& d) {
  d.compare("texture: file", a.file, b.file);
  d.compare("texture: texel", a.texel, b.texel);
  d.compare("texture: texel_color", a.texel_color, b.texel_color);
  d.compare("texture: color", a.color, b.color);
  d.compare("texture: blend", a.blend, b.blend);
}

void compare_surfaces(const SurfaceRecord& a, const SurfaceRecord& b, Difference& d) {
  d.compare("object", same(a.object, b.object), true);
  d.compare("shape", a.shape, b.shape);
  d.compare("face", a.face, b.face);
  d.compare("mesh", a.mesh, b.mesh);
  d.compare("triangle", a.triangle, b.triangle);
  d.compare("material", a.material, b.material);
  d.compare("ray to the surface", same(a.ray, b.ray), true);
  d.compare("object_ray", same(a.object_ray, b.object_ray), true);
  d.compare("t", a.t, b.t);
  d.compare("position", a.position, b.position);
  d.compare("object_position", a.object_position, b.object_position);
  d.compare("object_normal", a.object_normal, b.object_normal);
  d.compare("normal", a.normal, b.normal);
  d.compare("geometric", a.geometric, b.geometric);
  d.compare("bumped", a.bumped, b.bumped);
  d.compare("uv", a.uv, b.uv);
  d.compare("has_uv", a.has_uv, b.has_uv);
  d.compare("diffuse_color", a.diffuse_color, b.diffuse_color);
  d.compare("specular_color", a.specular_color, b.specular_color);
  d.compare("has a texture", a.texture.has_value(), b.texture.has_value());
  if (a.texture && b.texture) {
    compare_textures(*a.texture, *b.texture, d);
  }
}

void compare_walls(const RayRecord& a, const RayRecord& b, Difference& d) {
  d.compare("number of walls", a.walls.size(), b.walls.size());
  for (std::size_t i = 0; i < std::min(a.walls.size(), b.walls.size()); ++i) {
    const WallRecord& x = a.walls[i];
    const WallRecord& y = b.walls[i];
    d.compare("wall: object", same(x.object, y.object), true);
    d.compare("wall: t", x.t, y.t);
    d.compare("wall: position", x.position, y.position);
    d.compare("wall: normal", x.normal, y.normal);
    d.compare("wall: direction", x.direction, y.direction);
    d.compare("wall: mirrored", x.mirrored, y.mirrored);
  }
}

void compare_rays(const RayRecord& a, const RayRecord& b, Difference& d) {
  d.compare("kind", a.kind, b.kind);
  d.compare("parent", a.parent, b.parent);
  d.compare("depth", a.depth, b.depth);
  d.compare("weight", a.weight, b.weight);
  d.compare("ray", same(a.ray, b.ray), true);
  d.compare("start", a.start, b.start);
  d.compare("total_reflection", a.total_reflection, b.total_reflection);
  compare_walls(a, b, d);
  d.compare("trapped", a.trapped, b.trapped);
  d.compare("hit", a.surface.has_value(), b.surface.has_value());
  if (a.surface && b.surface) {
    compare_surfaces(*a.surface, *b.surface, d);
  }
  d.compare("inner_wall", a.inner_wall, b.inner_wall);
  d.compare("ambient", a.ambient, b.ambient);
  compare_lights(a, b, d);
  d.compare("local", a.local, b.local);
  for (BranchRecord RayRecord::*branch : {&RayRecord::mirror, &RayRecord::glass}) {
    d.compare("outcome", (a.*branch).outcome, (b.*branch).outcome);
    d.compare("factor", (a.*branch).factor, (b.*branch).factor);
    d.compare("child", (a.*branch).ray, (b.*branch).ray);
  }
  d.compare("sum", a.sum, b.sum);
  d.compare("color", a.color, b.color);
}

/// What happened in some pictures: each must occur, or the comparison shows little.
struct Met {
  int walls = 0, trapped = 0, total = 0, inner = 0, textures = 0, bumps = 0, meshes = 0;
  int dimmed = 0, blocked = 0, unlit = 0, instances = 0;

  void add(const RayRecord& ray) {
    walls += ray.walls.empty() ? 0 : 1;
    trapped += ray.trapped ? 1 : 0;
    total += ray.total_reflection ? 1 : 0;
    inner += ray.inner_wall ? 1 : 0;
    if (ray.surface) {
      textures += ray.surface->texture ? 1 : 0;
      bumps += ray.surface->bumped ? 1 : 0;
      meshes += ray.surface->shape == Shape::mesh ? 1 : 0;
      instances += ray.surface->object.instances.empty() ? 0 : 1;
    }
    for (const LightRecord& light : ray.lights) {
      unlit += light.unlit == Unlit::no ? 0 : 1;
      for (const LightSample& sample : light.samples) {
        blocked += sample.visibility == Color(0) ? 1 : 0;
        dimmed += sample.visibility != Color(0) && sample.visibility != Color(1) ? 1 : 0;
      }
    }
  }
};

CameraSample sample_at(const Tracer& tracer, const CameraRays& camera, int x, int y) {
  if (!tracer.course()) {
    const AdaptiveSampler sampler(tracer, camera);
    return (x + y) % 2 == 0 ? sampler.center_sample(x, y)
                            : sampler.sample(x, y, static_cast<std::uint32_t>(x % 5));
  }
  return {glm::dvec2(x, y) + 0.25, {0.5, -0.5}, {}, {}};
}

void expect_ray_trees(const SceneBuilder& b, RenderOptions options, Met& met) {
  options.width = 20;
  options.height = 15;
  const Tracer tracer(TraceScene(b.scene, b.assets, {.instance_names = true}), b.scene, options);
  ASSERT_EQ(tracer.status(), RenderStatus::complete);
  const CameraRays camera = tracer.camera();
  const WavefrontScene scene(tracer, camera);
  const WavefrontPointer memory = make_wavefront();
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const CameraSample sample = sample_at(tracer, camera, x, y);
      PixelRecorder recorder(tracer, 0);
      ScalarCounts counts;
      counts.recorder = &recorder;
      trace_sample(tracer, camera, sample, counts);
      const std::vector<RayRecord> rays = trace_recorded(scene, sample, *memory);
      ASSERT_EQ(rays.size(), recorder.rays.size()) << x << ' ' << y;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        Difference difference;
        compare_rays(rays[i], recorder.rays[i], difference);
        ASSERT_EQ(difference.first(), "") << "ray " << i << " of " << x << ' ' << y;
        met.add(rays[i]);
      }
    }
  }
}

TEST(RayTree, AgreesWithTheReference) {
  Met met;
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomScene random(seed);
    for (const Profile profile : {Profile::course, Profile::fine}) {
      RenderOptions options = default_options(profile);
      expect_ray_trees(random.b, options, met);
      options.features.texture_filter = !options.features.texture_filter;
      options.max_depth = 1;
      expect_ray_trees(random.b, options, met);
      options.features.reflect = options.features.shadows = false;
      options.fresnel = profile == Profile::fine;
      options.max_depth = 4;
      expect_ray_trees(random.b, options, met);
      options.features.reflect = true;
      expect_ray_trees(random.b, options, met);
      options.mode = Mode::intersect;
      expect_ray_trees(random.b, options, met);
      options.mode = Mode::normals;
      expect_ray_trees(random.b, options, met);
    }
    random.scene().camera.aperture = 0.1;
    random.scene().camera.focal_length = 5;
    expect_ray_trees(random.b, default_options(Profile::fine), met);
  }
  for (const int count : {met.walls, met.trapped, met.total, met.inner, met.textures, met.bumps,
                          met.meshes, met.dimmed, met.blocked, met.unlit, met.instances}) {
    EXPECT_GT(count, 20);
  }
}

// Each ray may cause half of what is left, until there are too many.
TEST(RayTree, OfManyRays) {
  RenderMaterial glass;
  glass.reflective = glass.transparent = glm::vec3(1);
  SceneBuilder b;
  const std::uint32_t m = b.material(glass);
  for (int i = 0; i < 40; ++i) {
    b.add(Shape::sphere,
          translate({float(i % 5) - 2, float(i / 5 % 4) - 1.5f, -4 - 1.3f * float(i / 20)}) *
              scale(glm::vec3(0.9f)),
          m);
  }
  RenderOptions options = default_options(Profile::fine);
  options.max_depth = 64;
  Met met;
  expect_ray_trees(b, options, met);
}

}  // namespace
}  // namespace scenefile::trace_test
