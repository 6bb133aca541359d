// scenefile_bench_replay SCENE [RUNS]: a lower bound for the time of a render. Records the ray
// queries of a 1024 x 768 picture with the profile course, and repeats them in Embree with nothing
// around them: all objects in a single user geometry, their inverses in 48 bytes, callbacks in
// single precision. Queries run one by one, and in packets of 8 and 16 similar rays of a tile
// (camera rays; shadow rays to the same light; reflected rays of the same depth); the minimum of
// RUNS counts. Prints "RAYS PACKETS ONES OBJECTS": CPU seconds with the fastest packet width for
// each kind of ray, and one by one.

#include "replay_shapes.h"
#include "scenefile/format/read_scene.h"
#include "scenefile/io/asset_roots.h"
#include "scenefile/io/file.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/trace/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

namespace {

using namespace scenefile;

constexpr int width = 1024;
constexpr int height = 768;
constexpr int tile = 16;

// Rays of one kind, divided into runs of neighbors.
struct Kind {
  std::vector<bench::RayRecord> rays;
  std::vector<std::size_t> runs{0};  // the end of each
  bool shadow = false;
};

enum { camera_rays, other_rays, camera_shadows, other_shadows, kinds };

// The queries of a tile.
class Tile {
 public:
  void add(const scenefile::RayRecord& ray) {
    const bool deep = ray.kind != RayKind::camera;
    put(deep ? other_rays : camera_rays, static_cast<int>(ray.kind) + 4 * ray.depth, ray.ray,
        ray.start, 1e30);
    for (const WallRecord& wall : ray.walls) {
      put(other_rays, -1, {wall.position, wall.direction}, offset, 1e30);
    }
    for (const LightRecord& light : ray.lights) {
      for (const LightSample& sample : light.samples) {
        if (sample.shadow_ray) {
          put(deep ? other_shadows : camera_shadows, static_cast<int>(light.light),
              {ray.surface->position, sample.to_light}, offset, sample.distance);
        }
      }
    }
  }

  void end(Kind (&all)[kinds]) {
    for (auto& [key, rays] : queries_) {
      Kind& kind = all[key.first];
      kind.rays.insert(kind.rays.end(), rays.begin(), rays.end());
      kind.runs.push_back(kind.rays.size());
    }
    queries_.clear();
  }

 private:
  static constexpr double offset = 1e-3;  // of the course profile

  void put(int kind, int group, const Ray& ray, double start, double end) {
    const glm::vec3 o(ray.origin);
    const glm::vec3 d(ray.direction);
    queries_[{kind, group}].push_back(
        {o.x, o.y, o.z, static_cast<float>(start), d.x, d.y, d.z, static_cast<float>(end)});
  }

  std::map<std::pair<int, int>, std::vector<bench::RayRecord>> queries_;
};

void record(const Explainer& explainer, Kind (&all)[kinds]) {
  Tile queries;
  for (int y0 = 0; y0 < height; y0 += tile) {
    for (int x0 = 0; x0 < width; x0 += tile) {
      for (int i = 0; i < tile * tile; ++i) {
        // Blocks of 4 x 4, so that a packet of 16 is as narrow as possible.
        const int x = x0 + i / 16 % 4 * 4 + i % 4;
        const int y = y0 + i / 64 * 4 + i / 4 % 4;
        for (const scenefile::RayRecord& ray : explainer.explain(x, y).rays) {
          queries.add(ray);
        }
      }
      queries.end(all);
    }
  }
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double replay(const bench::BareScene& scene, const Kind& kind, int lanes, int runs) {
  double best = kind.rays.empty() ? 0 : 1e30;
  for (int run = 0; run < runs && best > 0; ++run) {
    const double start = cpu_seconds();
    for (std::size_t i = 1; i < kind.runs.size(); ++i) {
      const std::size_t from = kind.runs[i - 1];
      scene.ask(&kind.rays[from], kind.runs[i] - from, lanes, kind.shadow);
    }
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

struct Placed {
  std::uint32_t group;
  DAffine world_from_group;
};

// All objects, with instances expanded. Returns false if there are too many.
bool copy_out(const RenderScene& scene, std::vector<bench::BareObject>& objects) {
  constexpr std::size_t most = 4'000'000;
  std::vector<Placed> stack{{scene.root, {}}};
  while (!stack.empty()) {
    const Placed now = stack.back();
    stack.pop_back();
    for (const RenderInstance& instance : scene.groups[now.group].instances) {
      stack.push_back(
          {instance.group, now.world_from_group * DAffine(instance.group_from_instance)});
    }
    for (const RenderPrimitive& primitive : scene.groups[now.group].primitives) {
      const DAffine world_from_object = now.world_from_group * DAffine(primitive.group_from_object);
      if (primitive.shape == Shape::mesh || objects.size() == most) {
        return false;
      }
      objects.push_back({Affine(inverse(world_from_object)),
                         shape_bounds(primitive.shape, world_from_object), primitive.shape});
    }
    if (stack.size() > most) {
      return false;
    }
  }
  return true;
}

RenderScene load(const char* path) {
  const Result<std::string> text = read_file(path, std::uint64_t{1} << 32);
  if (!text) {
    std::exit(3);
  }
  Diagnostics diagnostics;
  return prepare(read_scene(*text, {.compat_course = true, .limits = {}}, diagnostics), {}).scene;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    return 2;
  }
  const RenderScene scene = load(argv[1]);
  std::vector<bench::BareObject> objects;
  if (!copy_out(scene, objects)) {
    fmt::print("- - - -\n");  // meshes, or too many
    return 0;
  }
  RenderOptions options = default_options(Profile::course);
  options.width = width;
  options.height = height;
  options.features.super_sample = false;
  options.features.depthoffield = false;
  options.features.texture = false;
  const Assets assets{std::vector<Texture>(scene.texture_files.size()), {}};
  Kind all[kinds];
  all[camera_shadows].shadow = all[other_shadows].shadow = true;
  record(Explainer(scene, assets, options), all);
  const bench::BareScene bare(objects);
  const int runs = argc > 2 ? std::atoi(argv[2]) : 3;
  std::size_t rays = 0;
  double packets = 0;
  double ones = 0;
  for (const Kind& kind : all) {
    rays += kind.rays.size();
    const double one = replay(bare, kind, 1, runs);
    ones += one;
    packets += std::min({one, replay(bare, kind, 8, runs), replay(bare, kind, 16, runs)});
  }
  fmt::print("{} {:.4f} {:.4f} {}\n", rays, packets, ones, objects.size());
}
