#include "scenefile/noise/path_truth.h"

#include "scenefile/noise/block_means.h"
#include "scenefile/path/path_kernel.h"
#include "scenefile/trace/optics.h"
#include "scenefile/trace/tasks.h"
#include "scenefile/trace/trace_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <deque>
#include <numbers>
#include <optional>

namespace scenefile {

namespace {

using glm::dvec3;
using std::numbers::pi;

using Weights = std::array<Color, change_count>;

// A pass draws this many samples per pixel. Passes use sequences of samples in turn, whose means
// are independent: how much they differ is the noise of the truth, which is less than that of
// random samples.
constexpr std::uint32_t of_pass = 4;
constexpr std::uint32_t sequences = 4;

// 0 / 0 is 1: what has no part in a product does not change it.
Color quotient(const Color& a, const Color& b) {
  Color q;
  for (int c = 0; c < 3; ++c) {
    q[c] = b[c] > 0 ? a[c] / b[c] : 1;
  }
  return q;
}

// The diffuse and the glossy part of a BSDF without cosine.
struct Reflectance {
  Color diffuse{0};
  Color glossy{0};
  Color sum() const { return diffuse + glossy; }
};

double lobe_of(double cosine, double shininess) {
  return cosine > 0 ? std::pow(cosine, shininess) * (shininess + 2) / (2 * pi) : 0;
}

Reflectance reflectance_of(const PathPoint& point, const dvec3& to_light) {
  const Facing& f = point.facing;
  const dvec3 mirrored = 2 * glm::dot(f.normal, f.to_eye) * f.normal - f.to_eye;
  return {point.bsdf.diffuse / pi,
          point.bsdf.glossy * lobe_of(glm::dot(mirrored, to_light), point.bsdf.shininess)};
}

// Whose glossy part is divided by the cosine, which the light is multiplied by.
Color flat_glossy(const PathPoint& point, const dvec3& to_light, const Reflectance& r) {
  return r.diffuse + r.glossy / std::max(1e-2, glm::dot(point.facing.normal, to_light));
}

// What both light samples and scattered directions change.
void weigh_reflectance(const PathPoint& point, const dvec3& to_light, Weights& w) {
  const auto at = [&w](Change change) -> Color& { return w[static_cast<std::size_t>(change)]; };
  const Reflectance r = reflectance_of(point, to_light);
  const Color all = r.sum();
  const Color white = glm::sign(point.bsdf.diffuse) / pi;
  at(Change::diffuse_missing) *= quotient(white + r.glossy, all);
  at(Change::diffuse_twice) *= quotient(r.diffuse * point.bsdf.diffuse + r.glossy, all);
  at(Change::diffuse_without_pi) *= quotient(r.diffuse * pi + r.glossy, all);
  if (point.bsdf.glossy == Color(0)) {
    return;
  }
  const Facing& f = point.facing;
  at(Change::glossy_scale) *=
      quotient(r.diffuse + r.glossy * (2 * pi / (point.bsdf.shininess + 2)), all);
  at(Change::glossy_missing) *= quotient(r.diffuse, all);
  at(Change::glossy_flat) *= quotient(flat_glossy(point, to_light, r), all);
  const double half = glm::dot(glm::normalize(f.to_eye + to_light), f.normal);
  at(Change::glossy_blinn) *=
      quotient(r.diffuse + point.bsdf.glossy * lobe_of(half, point.bsdf.shininess), all);
  const double to_eye = glm::dot(f.to_eye, to_light);
  at(Change::glossy_eye) *=
      quotient(r.diffuse + point.bsdf.glossy * lobe_of(to_eye, point.bsdf.shininess), all);
  if (luminance(point.bsdf.glossy) > luminance(point.bsdf.diffuse)) {
    at(Change::lobe_alone) *= quotient(r.glossy, all);
  }
}

Color times(const Color& color, double by) {
  return color * by;
}

// What programs with a mistake may take for the numbers of a lamp.
struct LampNumbers {
  explicit LampNumbers(const Lamps& lamps) {
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      areas.push_back(lamps.area(i));
      mean_area += areas.back() / static_cast<double>(lamps.size());
    }
    if (!areas.empty()) {
      first_emission = lamps.emission(0);
      last_emission = lamps.emission(lamps.size() - 1);
    }
  }

  std::vector<double> areas;  // by triangle
  double mean_area = 0;
  Color first_emission{0};
  Color last_emission{0};
};

void weigh_sample(const PathPoint& point, const PathLight& light, const LampNumbers& lamps,
                  Weights& w) {
  const auto at = [&w](Change change) -> Color& { return w[static_cast<std::size_t>(change)]; };
  const double cosine = std::max(1e-4, glm::dot(point.facing.normal, light.to_light));
  weigh_reflectance(point, light.to_light, w);
  const Reflectance r = reflectance_of(point, light.to_light);
  const Color white = glm::sign(point.bsdf.diffuse) / pi;
  at(Change::diffuse_missing_direct) *= quotient(white + r.glossy, r.sum());
  at(Change::diffuse_twice_direct) *= quotient(r.diffuse * point.bsdf.diffuse + r.glossy, r.sum());
  at(Change::surface_cosine_direct) /= cosine;
  at(Change::surface_cosine) /= cosine;
  at(Change::surface_cosine_twice) *= cosine;
  at(Change::eye_cosine) *= glm::dot(point.facing.normal, point.facing.to_eye) / cosine;
  at(Change::glossy_missing_direct) *= quotient(r.diffuse, r.sum());
  at(Change::glossy_flat_direct) *= quotient(flat_glossy(point, light.to_light, r), r.sum());
  if (light.lamp == no_index) {
    return;
  }
  const double lamp_cosine = std::max(1e-4, light.lamp_cosine);
  at(Change::lamp_cosine) /= lamp_cosine;
  at(Change::lamp_cosine_twice) *= lamp_cosine;
  at(Change::lamp_cosine_of_surface) *= cosine / lamp_cosine;
  at(Change::falloff_distance) *= light.distance;
  at(Change::falloff_none) *= light.distance * light.distance;
  at(Change::falloff_cube) /= light.distance;
  // Densities of points on triangles, against uniform ones: (u, v (1 - u)); (u (1 - v), v); three
  // numbers divided by their sum.
  const double u = light.lamp_weights.x;
  const double v = light.lamp_weights.y;
  at(Change::corner_points) /= std::max(1e-3, 2 * (1 - u));
  at(Change::edge_points) /= std::max(1e-3, 2 * (1 - v));
  const double most = std::max({u, v, 1 - u - v});
  at(Change::normalized_points) /= 6 * most * most * most;
  const double area = lamps.areas[light.lamp];
  at(Change::lamp_area) /= area;
  at(Change::lamp_area_divided) /= area * area;
  at(Change::lamp_area_of_first) *= lamps.areas.front() / area;
  at(Change::lamp_area_mean) *= lamps.mean_area / area;
  at(Change::lamp_emission) *= quotient(Color(1), light.emission);
  at(Change::lamp_emission_of_first) *= quotient(lamps.first_emission, light.emission);
  at(Change::lamp_emission_of_last) *= quotient(lamps.last_emission, light.emission);
  at(Change::first_lamp) *= light.lamp == 0 ? 1.0 : 0.0;
  at(Change::last_lamp) *= light.lamp + 1 == lamps.areas.size() ? 1.0 : 0.0;
}

void weigh_specular(const PathPoint& point, const BsdfSample& next, Weights& w) {
  const auto at = [&w](Change change) -> Color& { return w[static_cast<std::size_t>(change)]; };
  const double cosine = glm::dot(point.facing.normal, point.facing.to_eye);
  if (next.lobe == BsdfLobe::mirror) {
    at(Change::mirror_cosine) *= cosine;
    at(Change::mirror_without_color) *= quotient(Color(1), point.bsdf.mirror);
    return;
  }
  const double eta = point.facing.outside ? 1 / point.bsdf.ior : point.bsdf.ior;
  const double reflected = fresnel_reflectance(cosine, eta);
  const bool reflects = next.lobe == BsdfLobe::reflection;
  if (reflected >= 1) {
    at(Change::no_total_reflection) *= 0.0;
    return;
  }
  const double share = reflects ? reflected : 1 - reflected;
  at(Change::fresnel_twice) *= share;
  at(Change::no_fresnel) *= reflects ? 0 : 1 / share;
  at(Change::half_fresnel) *= 0.5 / share;
  at(Change::only_reflection) *= reflects ? 1 / share : 0;
  at(Change::swapped_fresnel) *= (1 - share) / share;
  const double base = (1 - point.bsdf.ior) / (1 + point.bsdf.ior);
  const double inside = std::sqrt(std::max(0.0, 1 - eta * eta * (1 - cosine * cosine)));
  const double power = std::pow(1 - (point.facing.outside ? cosine : inside), 5);
  const double schlick = base * base + (1 - base * base) * power;
  at(Change::schlick) *= (reflects ? schlick : 1 - schlick) / share;
  const double larger = std::abs(base) + (1 - std::abs(base)) * power;
  at(Change::schlick_without_square) *= (reflects ? larger : 1 - larger) / share;
}

void weigh_rough(const PathPoint& point, const dvec3& direction, Weights& w) {
  const auto at = [&w](Change change) -> Color& { return w[static_cast<std::size_t>(change)]; };
  const double cosine = std::max(1e-2, glm::dot(point.facing.normal, direction));
  weigh_reflectance(point, direction, w);
  const Reflectance r = reflectance_of(point, direction);
  const Color white = glm::sign(point.bsdf.diffuse) / pi;
  at(Change::diffuse_missing_indirect) *= quotient(white + r.glossy, r.sum());
  at(Change::diffuse_twice_indirect) *=
      quotient(r.diffuse * point.bsdf.diffuse + r.glossy, r.sum());
  at(Change::glossy_missing_indirect) *= quotient(r.diffuse, r.sum());
  at(Change::surface_cosine_indirect) /= cosine;
  at(Change::surface_cosine_indirect_twice) *= cosine;
  at(Change::surface_cosine) /= cosine;
  at(Change::uniform_density) *= times(Color(2), cosine);
  at(Change::cosine_density) /= 2 * cosine;
  at(Change::polar_density) *= 2 / (pi * std::sqrt(std::max(1e-4, 1 - cosine * cosine)));
  at(Change::y_directions) *= direction.y > 0 ? 1.0 : 0.0;
  at(Change::z_directions) *= direction.z > 0 ? 1.0 : 0.0;
  const Color albedo = point.bsdf.diffuse + point.bsdf.glossy;
  at(Change::color_roulette) *= std::min(1.0, std::max({albedo.x, albedo.y, albedo.z}));
  const Color value = r.sum();
  at(Change::gray_by_luminance) *= quotient(Color(luminance(value)), value);
  at(Change::gray_by_mean) *= quotient(Color((value.x + value.y + value.z) / 3), value);
}

constexpr std::size_t kind_count =
    std::size_t{2} * (most_rough + 1) * (most_mirror + 1) * (most_glass + 1);

std::size_t index_of(const LightKind& kind) {
  const auto least = [](int value, int most) {
    return static_cast<std::size_t>(std::min(value, most));
  };
  return ((static_cast<std::size_t>(kind.hit) * (most_rough + 1) + least(kind.rough, most_rough)) *
              (most_mirror + 1) +
          least(kind.mirror, most_mirror)) *
             (most_glass + 1) +
         least(kind.glass, most_glass);
}

LightKind kind_at(std::size_t index) {
  LightKind kind;
  kind.glass = static_cast<std::uint8_t>(index % (most_glass + 1));
  index /= most_glass + 1;
  kind.mirror = static_cast<std::uint8_t>(index % (most_mirror + 1));
  index /= most_mirror + 1;
  kind.rough = static_cast<std::uint8_t>(index % (most_rough + 1));
  kind.hit = index / (most_rough + 1) != 0;
  return kind;
}

// Sums over the paths of a block.
struct BlockSums {
  std::array<Color, kind_count> kinds{};
  Weights sampled{};
  Weights hit{};
  std::array<Color, sample_tone_count> toned{};
  std::array<Color, most_lamp_triangles> lamps{};  // light samples
  bool glass = false;
  bool mirror = false;
  bool glossy = false;
};

// What a truth needs of its scene, besides the paths.
struct TruthScene {
  explicit TruthScene(const PathScene& scene);

  // What arrives of a light sample if glass casts no shadows.
  Color through_glass(const PathScene& scene, const PathPoint& point, const PathLight& light) const;

  LampNumbers lamps;
  std::optional<Transmission> clear_glass;  // none if the scene has no meshes that are all glass
};

TruthScene::TruthScene(const PathScene& scene) : lamps(scene.lamps) {
  const std::vector<MeshMaterials>& meshes = scene.tracer.assets.mesh_materials;
  const auto is_glass = [](const MeshMaterials& mesh) {
    return !mesh.of_triangle.empty() &&
           std::all_of(mesh.of_triangle.begin(), mesh.of_triangle.end(), [&](std::uint32_t m) {
             return m != mesh_no_index && mesh.materials[m].illum == illum_glass;
           });
  };
  std::vector<bool> opaque;
  for (const MeshMaterials& mesh : meshes) {
    opaque.push_back(!is_glass(mesh));
  }
  bool only_meshes = true;  // whose materials are those of faces
  for (const RenderGroup& group : scene.tracer.scene.groups) {
    for (const RenderPrimitive& primitive : group.primitives) {
      only_meshes = only_meshes && primitive.mesh < meshes.size() &&
                    !meshes[primitive.mesh].of_triangle.empty();
    }
  }
  if (only_meshes && std::find(opaque.begin(), opaque.end(), false) != opaque.end()) {
    clear_glass.emplace(std::vector<dvec3>(scene.tracer.scene.materials.size(), dvec3(1)),
                        std::move(opaque));
  }
}

Color TruthScene::through_glass(const PathScene& scene, const PathPoint& point,
                                const PathLight& light) const {
  if (!clear_glass || light.lamp == no_index || light.contribution != Color(0)) {
    return light.contribution;
  }
  constexpr double before_light = 1 - 1e-9;
  return light.unshadowed *
         scene.tracer.accelerator.transmittance({point.position, light.to_light}, point.offset,
                                                before_light * light.distance, *clear_glass);
}

void add_path(const PathRecord& path, const PathScene& scene, const TruthScene& facts,
              BlockSums& sums) {
  LightKind kind;
  Weights along;
  along.fill(Color(1));
  for (const PathVertex& v : path.vertices) {
    sums.glossy = sums.glossy || v.point.bsdf.glossy != Color(0);
    if (v.emission != Color(0)) {
      const Color light = v.throughput * v.emission;
      kind.hit = true;
      sums.kinds[index_of(kind)] += light;
      if (kind.bounces() > 0) {
        for (std::size_t c = 0; c < change_count; ++c) {
          sums.hit[c] += along[c] * light;
        }
      }
    }
    kind.hit = false;
    for (std::uint32_t i = v.first_light; i < v.first_light + v.lights; ++i) {
      const PathLight& light = path.lights[i];
      if (light.unshadowed == Color(0)) {
        continue;
      }
      const Color arrived = v.throughput * light.contribution;
      sums.kinds[index_of(kind)] += arrived;
      sums.sampled[static_cast<std::size_t>(Change::no_visibility)] +=
          v.throughput * light.unshadowed;
      sums.sampled[static_cast<std::size_t>(Change::glass_visibility)] +=
          v.throughput * facts.through_glass(scene, v.point, light);
      if (light.lamp < most_lamp_triangles) {
        sums.lamps[light.lamp] += arrived;
      }
      if (arrived != Color(0)) {
        Weights here = along;
        weigh_sample(v.point, light, facts.lamps, here);
        for (std::size_t c = 0; c < change_count; ++c) {
          if (c != static_cast<std::size_t>(Change::no_visibility) &&
              c != static_cast<std::size_t>(Change::glass_visibility)) {
            sums.sampled[c] += here[c] * arrived;
          }
        }
      }
    }
    if (v.next.lobe == BsdfLobe::none) {
      break;
    }
    if (!v.next.specular()) {
      weigh_rough(v.point, v.next.to_light, along);
      ++kind.rough;
    } else {
      weigh_specular(v.point, v.next, along);
      const bool is_mirror = v.next.lobe == BsdfLobe::mirror;
      ++(is_mirror ? kind.mirror : kind.glass);
      (is_mirror ? sums.mirror : sums.glass) = true;
    }
  }
}

// Each vertex adds its light to the terms of its number of bounces.
void add_loose(const PathRecord& path, std::size_t block, double share, LooseThroughputs& sums) {
  double likelihood = share;
  Color last(1);
  Color sum(0);
  const std::size_t count = std::min(path.vertices.size(), LooseThroughputs::most + 1);
  for (std::size_t n = 0; n < count; ++n) {
    const PathVertex& v = path.vertices[n];
    const Color light = likelihood * (v.emission + v.light);
    sums.one[n][block] += light;
    sums.last[n][block] += last * light;
    sums.sum[n][block] += sum * light;
    likelihood /= v.continuation;
    last = v.next.weight;
    sum += last;
  }
}

constexpr int longest_of_pool = 24;  // users continue them by their mean growth

std::vector<PathStep> steps_of(const PathRecord& path) {
  std::vector<PathStep> steps;
  PathStep step;
  Color whitened(1);
  double gone_on = 1;  // the roulette of the few that it ends is taken back
  for (const PathVertex& v : path.vertices) {
    Color light = v.emission;
    Color flat = v.emission;
    for (std::uint32_t i = v.first_light; i < v.first_light + v.lights; ++i) {
      const PathLight& l = path.lights[i];
      const double cosine = std::max(1e-2, glm::dot(v.point.facing.normal, l.to_light));
      light += l.contribution;
      flat += l.contribution / cosine;
    }
    step.direct = static_cast<float>(gone_on * luminance(v.throughput * light));
    step.flat_direct = static_cast<float>(gone_on * luminance(v.throughput * flat));
    step.white_direct =
        static_cast<float>(std::min(1e30, gone_on * luminance(v.throughput * whitened * light)));
    steps.push_back(step);
    if (!v.next.specular()) {
      const Reflectance r = reflectance_of(v.point, v.next.to_light);
      whitened *= quotient(glm::sign(v.point.bsdf.diffuse) / pi + r.glossy, r.sum());
      const double cosine = std::max(1e-2, glm::dot(v.point.facing.normal, v.next.to_light));
      step.flatness = static_cast<float>(std::min(1e30, step.flatness / cosine));
      ++step.rough;
    }
    gone_on *= v.continuation;
  }
  const PathEnd end = path.vertices.empty() ? PathEnd::none : path.vertices.back().end;
  if (end != PathEnd::max_depth && end != PathEnd::roulette) {
    steps.resize(longest_of_pool + 1);  // no light comes from beyond
  }
  return steps;
}

// Sums over passes.
struct Totals {
  std::vector<BlockSums> blocks;
  std::array<BlockColors, sequences> sums;
  std::array<std::vector<Weights>, sequences> changed;
  std::vector<Color> pixels;
  std::vector<Color> pixel_squares;
};

void draw_block(const PathScene& scene, const TruthScene& facts, std::uint32_t pass,
                std::size_t block, const PathTruth& truth, Totals& totals, RayCounts& counts) {
  PathRecord path;
  Color sum(0);
  BlockSums& sums = totals.blocks[block];
  Weights& changed = totals.changed[pass % sequences][block];
  const auto add_changed = [&](double by) {
    for (std::size_t c = 0; c < change_count; ++c) {
      changed[c] += by * (sums.sampled[c] + sums.hit[c]);
    }
  };
  add_changed(-1);
  for_each_pixel(truth, block, [&](int x, int y, std::size_t pixel) {
    for (std::uint32_t i = 0; i < of_pass; ++i) {
      const Color light = path_light(scene, x, y, pass / sequences * of_pass + i, counts, &path);
      if (!std::isfinite(luminance(light))) {
        continue;
      }
      sum += light;
      totals.pixels[pixel] += light;
      totals.pixel_squares[pixel] += light * light;
      for (std::size_t t = 0; t < sample_tone_count; ++t) {
        sums.toned[t] += toned(static_cast<SampleTone>(t), light);
      }
      add_path(path, scene, facts, sums);
    }
  });
  totals.sums[pass % sequences][block] += sum;
  add_changed(1);
}

double pixels_of(const PathTruth& truth, std::size_t b) {
  const int left = static_cast<int>(b) % truth.columns * block_side;
  const int top = static_cast<int>(b) / truth.columns * block_side;
  return std::min(block_side, truth.width - left) * std::min(block_side, truth.height - top);
}

void set_means(const PathScene& scene, const Totals& totals, PathTruth& truth) {
  const double n = truth.samples;
  truth.pixels.resize(totals.pixels.size());
  truth.sample_variances.resize(totals.pixels.size());
  for (std::size_t i = 0; i < totals.pixels.size(); ++i) {
    truth.pixels[i] = totals.pixels[i] / n;
    truth.sample_variances[i] =
        glm::max(Color(0),
                 (totals.pixel_squares[i] / n - truth.pixels[i] * truth.pixels[i]) * (n / (n - 1)));
  }
  truth.noise.resize(truth.blocks());
  for (BlockColors& picture : truth.toned) {
    picture.resize(truth.blocks());
  }
  const bool few_lamps = scene.lamps.size() > 1 && scene.lamps.size() <= most_lamp_triangles;
  truth.lamp_samples.assign(few_lamps ? scene.lamps.size() : 0, BlockColors(truth.blocks()));
  for (ChangedPicture& changed : truth.changes) {
    changed.sampled.resize(truth.blocks());
    changed.hit.resize(truth.blocks());
    changed.noise.resize(truth.blocks());
  }
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    const BlockSums& sums = totals.blocks[b];
    const double all = pixels_of(truth, b) * n;
    Color sum(0);
    for (std::size_t k = 0; k < kind_count; ++k) {
      if (sums.kinds[k] != Color(0)) {
        BlockColors& kind = truth.kinds[kind_at(k)];
        kind.resize(truth.blocks());
        kind[b] = sums.kinds[k] / all;
        sum += sums.kinds[k];
      }
    }
    // The variance of a sum of independent ones.
    const auto variance = [&](const Color& total, const auto& part) {
      Color squares(0);
      for (std::size_t i = 0; i < sequences; ++i) {
        const Color off = part(i) - total / double(sequences);
        squares += off * off;
      }
      return squares * (sequences / (sequences - 1.0)) / (all * all);
    };
    truth.noise[b] = variance(sum, [&](std::size_t i) { return totals.sums[i][b]; });
    for (std::size_t c = 0; c < change_count; ++c) {
      ChangedPicture& changed = truth.changes[c];
      changed.sampled[b] = sums.sampled[c] / all;
      changed.hit[b] = sums.hit[c] / all;
      changed.noise[b] = variance(sums.sampled[c] + sums.hit[c],
                                  [&](std::size_t i) { return totals.changed[i][b][c]; });
    }
    for (std::size_t t = 0; t < sample_tone_count; ++t) {
      truth.toned[t][b] = sums.toned[t] / all;
    }
    for (std::size_t i = 0; i < truth.lamp_samples.size(); ++i) {
      truth.lamp_samples[i][b] = sums.lamps[i] / all;
    }
    truth.glass = truth.glass || sums.glass;
    truth.mirror = truth.mirror || sums.mirror;
    truth.glossy = truth.glossy || sums.glossy;
  }
  truth.lamp_areas.clear();
  for (std::size_t i = 0; i < scene.lamps.size(); ++i) {
    truth.lamp_areas.push_back(scene.lamps.area(i));
  }
}

// Whether the passes so far leave no time for another one.
bool time_is_over(std::clock_t start, int passes, double seconds) {
  const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return seconds > 0 && spent * (passes + 1) / passes > seconds;
}

RenderOptions as_truth(RenderOptions options) {
  options.mis = false;  // so that light samples and hits are separate, as in most programs
  options.light_samples = 1;
  options.crop.reset();
  options.layers.clear();
  options.denoise = false;
  return options;
}

std::deque<PathScene> scenes_of(const TraceScene& traced, const RenderScene& scene,
                                RenderOptions options) {
  options = as_truth(std::move(options));
  std::deque<PathScene> scenes;
  for (std::uint32_t i = 0; i < sequences; ++i) {
    scenes.emplace_back(traced, scene, options);
    ++options.seed;
  }
  return scenes;
}

// The other side of faces that emit light.
void make_two_sided(Mesh& mesh, MeshMaterials& materials) {
  const std::size_t count = materials.of_triangle.size();
  const auto reversed = [](std::array<std::uint32_t, 3> corners) {
    std::swap(corners[1], corners[2]);
    return corners;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t material = materials.of_triangle[i];
    if (material == mesh_no_index || materials.materials[material].emission == glm::vec3(0)) {
      continue;
    }
    mesh.triangles.push_back(reversed(mesh.triangles[i]));
    for (auto* list : {&mesh.triangle_normals, &mesh.triangle_uvs}) {
      if (!list->empty()) {
        list->push_back(list == &mesh.triangle_normals
                            ? std::array{mesh_no_index, mesh_no_index, mesh_no_index}
                            : reversed((*list)[i]));
      }
    }
    materials.of_triangle.push_back(material);
  }
}

// False if nothing changes.
bool change(Variant variant, const PathTruth& truth, RenderScene& scene, Assets& assets,
            RenderOptions& options) {
  bool changed = false;
  switch (variant) {
    case Variant::two_sided_lamps:
      for (std::size_t m = 0; m < assets.mesh_materials.size(); ++m) {
        make_two_sided(assets.meshes[m], assets.mesh_materials[m]);
      }
      return has_emissive_faces(assets);
    case Variant::inverted_index:
      for (RenderMaterial& material : scene.materials) {
        material.ior = 1 / material.ior;
      }
      for (MeshMaterials& mesh : assets.mesh_materials) {
        for (FaceMaterial& material : mesh.materials) {
          material.ior = 1 / material.ior;
        }
      }
      return truth.glass;
    case Variant::always_enters:
      return truth.glass;  // of its paths, not of the scene
    case Variant::flat_normals:
      for (Mesh& mesh : assets.meshes) {
        changed = changed || !mesh.triangle_normals.empty();
        mesh.triangle_normals.clear();
      }
      return changed;
    case Variant::lamp_parallelograms:
      return !truth.lamp_areas.empty();  // likewise
    case Variant::all_bounces:
      changed = options.direct_only || options.max_depth > 0;
      options.direct_only = false;
      options.max_depth = 0;
      return changed;
    case Variant::shaded_mirrors:
      return truth.mirror;  // likewise
    case Variant::shaded_glass:
      return truth.glass;
  }
  return false;
}

// The truth and what the same paths change: only that has the noise of few passes.
VariantPicture draw_variant(Variant variant, const std::deque<PathScene>& scenes,
                            const PathTruth& truth, double seconds) {
  BlockColors sums(truth.blocks(), Color(0));
  std::vector<BlockColors> differences;  // from the truth's, after 1, 2, 4, ... passes
  const std::clock_t start = std::clock();
  std::uint32_t passes = 0;
  do {
    for_each_task(truth.blocks(), [&](std::size_t block) {
      RayCounts counts;
      for_each_pixel(truth, block, [&](int x, int y, std::size_t) {
        for (std::uint32_t i = 0; i < of_pass; ++i) {
          const Color light = path_light(scenes[passes % sequences], x, y,
                                         passes / sequences * of_pass + i, counts);
          sums[block] += std::isfinite(luminance(light)) ? light : Color(0);
        }
      });
    });
    ++passes;
    if (std::has_single_bit(passes)) {
      differences.push_back(combined(sums, -1, truth.first_passes[differences.size()]));
    }
  } while (!std::has_single_bit(passes) ||
           (differences.size() < truth.first_passes.size() &&
            (differences.size() < 2 ||  // otherwise the noise is not known
             !time_is_over(start, static_cast<int>(passes), seconds / 2))));
  VariantPicture result{variant, BlockColors(truth.blocks(), Color(0)),
                        BlockColors(truth.blocks(), Color(0))};
  for (const auto& [kind, light] : truth.kinds) {
    result.picture = combined(result.picture, 1, light);
  }
  // The passes 1, 2, 3 and 4, 5 to 8, ... are independent; their means differ by their noise.
  const std::size_t groups = differences.size();
  for (std::size_t b = 0; b < truth.blocks(); ++b) {
    const double samples = of_pass * pixels_of(truth, b);
    const Color mean = differences.back()[b] / (samples * passes);
    result.picture[b] += mean;
    for (std::size_t g = 0; groups > 1 && g < groups; ++g) {
      const double count = g == 0 ? 1 : std::exp2(static_cast<double>(g) - 1);
      const Color sum = g == 0 ? differences[0][b] : differences[g][b] - differences[g - 1][b];
      const Color off = sum / (samples * count) - mean;
      result.noise[b] += count * off * off / (static_cast<double>((groups - 1) * passes));
    }
  }
  return result;
}

}  // namespace

Color toned(SampleTone tone, const Color& value) {
  switch (tone) {
    case SampleTone::clamp:
      return glm::min(value, Color(1));
    case SampleTone::reinhard:
      return value / (1.0 + value);
    case SampleTone::film:
      return 1.0 - glm::exp(-value);
  }
  return value;
}

RenderStatus draw_truth(const TraceScene& traced, const RenderScene& scene,
                        const RenderOptions& options, double seconds, std::uint32_t samples,
                        const Progress& progress, PathTruth& truth) {
  if (traced.status() != RenderStatus::complete) {
    return traced.status();
  }
  const std::deque<PathScene> scenes = scenes_of(traced, scene, options);
  const PathScene& paths = scenes.front();
  const TruthScene facts(paths);
  truth.width = options.width;
  truth.height = options.height;
  truth.height_angle = scene.camera.fov_y;
  truth.columns = (truth.width + block_side - 1) / block_side;
  truth.rows = (truth.height + block_side - 1) / block_side;
  Totals totals;
  totals.blocks.resize(truth.blocks());
  totals.sums.fill(BlockColors(truth.blocks(), Color(0)));
  totals.changed.fill(std::vector<Weights>(truth.blocks()));
  totals.pixels.resize(std::size_t(truth.width) * truth.height);
  totals.pixel_squares.resize(totals.pixels.size());
  const ThreadLimit limit(options.threads);
  const std::clock_t start = std::clock();
  std::uint32_t passes = 0;
  do {
    for_each_task(truth.blocks(), [&](std::size_t block) {
      RayCounts counts;
      if (!paths.tracer.accelerator.overwhelmed()) {
        draw_block(scenes[passes % sequences], facts, passes, block, truth, totals, counts);
      }
    });
    if (paths.tracer.accelerator.overwhelmed()) {
      return RenderStatus::limit_reached;
    }
    ++passes;
    if (std::has_single_bit(passes)) {
      BlockColors& sum = truth.first_passes.emplace_back(truth.blocks(), Color(0));
      for (const BlockColors& one : totals.sums) {
        for (std::size_t b = 0; b < sum.size(); ++b) {
          sum[b] += one[b];
        }
      }
    }
    const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (progress && !progress(std::min(1.0, std::max(double(passes * of_pass) / samples,
                                                     seconds > 0 ? spent / seconds : 0)))) {
      return RenderStatus::cancelled;
    }
  } while (passes % sequences != 0 ||
           (passes * of_pass < samples && !time_is_over(start, static_cast<int>(passes), seconds)));
  truth.samples = double(passes) * of_pass;
  set_means(paths, totals, truth);
  return RenderStatus::complete;
}

RenderStatus draw_throughputs(const TraceScene& traced, const RenderScene& scene,
                              const RenderOptions& options, double seconds,
                              const Progress& progress, PathTruth& truth) {
  RenderOptions endless = as_truth(options);
  endless.continuation = 0.85;  // a seventh of the paths reach the last bounce
  endless.max_depth = LooseThroughputs::most + 1;
  const ThreadLimit limit(options.threads);
  for (std::size_t uniform = 0; uniform < truth.throughputs.size(); ++uniform) {
    std::deque<PathScene> scenes = scenes_of(traced, scene, endless);
    std::vector<LooseThroughputs>& lights = truth.throughputs[uniform];
    for (PathScene& paths : scenes) {
      paths.uniform_directions = uniform == 1;
    }
    lights.resize(sequences);
    for (LooseThroughputs& light : lights) {
      for (auto* terms : {&light.one, &light.last, &light.sum}) {
        terms->fill(BlockColors(truth.blocks(), Color(0)));
      }
    }
    const std::clock_t start = std::clock();
    std::uint32_t passes = 0;
    do {
      for_each_task(truth.blocks(), [&](std::size_t block) {
        RayCounts counts;
        PathRecord path;
        for (std::uint32_t i = 0; i < sequences; ++i) {
          for_each_pixel(truth, block, [&](int x, int y, std::size_t) {
            if (std::isfinite(luminance(path_light(scenes[i], x, y, passes, counts, &path)))) {
              add_loose(path, block, 1 / pixels_of(truth, block), lights[i]);
            }
          });
        }
      });
      ++passes;
      if (progress && !progress(1)) {
        return RenderStatus::cancelled;
      }
    } while (!time_is_over(start, static_cast<int>(passes), seconds / 2));
    for (LooseThroughputs& light : lights) {
      for (auto* terms : {&light.one, &light.last, &light.sum}) {
        for (BlockColors& term : *terms) {
          for (Color& value : term) {
            value /= double(passes);
          }
        }
      }
    }
  }
  return RenderStatus::complete;
}

void draw_pools(const TraceScene& traced, const RenderScene& scene, const RenderOptions& options,
                PathTruth& truth) {
  constexpr std::size_t most_blocks = 64;
  constexpr std::uint32_t spots = 4;  // pixels of a block
  constexpr std::uint32_t of_spot = 32;
  RenderOptions endless = as_truth(options);
  endless.continuation = 0.99;
  endless.max_depth = longest_of_pool;
  const ThreadLimit limit(options.threads);
  const std::size_t count = std::min(most_blocks, truth.blocks());
  truth.pools.resize(count);
  for (int uniform = 0; uniform < 2; ++uniform) {
    PathScene paths(traced, scene, endless);
    paths.uniform_directions = uniform == 1;
    for_each_task(count, [&](std::size_t i) {
      PathPool& pool = truth.pools[i];
      pool.block = (2 * i + 1) * truth.blocks() / (2 * count);
      const int left = static_cast<int>(pool.block) % truth.columns * block_side;
      const int top = static_cast<int>(pool.block) / truth.columns * block_side;
      RayCounts counts;
      PathRecord path;
      for (std::uint32_t spot = 0; spot < spots; ++spot) {
        const int x = std::min(left + (spot % 2 == 0 ? 2 : 6), truth.width - 1);
        const int y = std::min(top + (spot < 2 ? 2 : 6), truth.height - 1);
        for (std::uint32_t sample = 0; sample < of_spot; ++sample) {
          path_light(paths, x, y, sample, counts, &path);
          pool.paths[uniform].push_back(steps_of(path));
        }
      }
    });
  }
}

RenderStatus draw_variants(std::span<const Variant> variants, const RenderScene& scene,
                           const Assets& assets, const RenderOptions& options, double seconds,
                           const Progress& progress, PathTruth& truth) {
  const ThreadLimit limit(options.threads);
  struct Changed {
    Variant variant;
    RenderScene scene;
    Assets assets;
    RenderOptions options;
  };
  std::vector<Changed> list;
  for (const Variant variant : variants) {
    Changed changed{variant, scene, assets, options};
    if (change(variant, truth, changed.scene, changed.assets, changed.options)) {
      list.push_back(std::move(changed));
    }
  }
  for (const Changed& changed : list) {
    if (progress && !progress(1)) {
      return RenderStatus::cancelled;
    }
    const TraceScene traced(changed.scene, changed.assets, {.threads = options.threads});
    if (traced.status() != RenderStatus::complete) {
      return traced.status();
    }
    std::deque<PathScene> scenes = scenes_of(traced, changed.scene, changed.options);
    for (PathScene& paths : scenes) {
      paths.always_enters = changed.variant == Variant::always_enters;
      paths.shaded_mirrors = changed.variant == Variant::shaded_mirrors;
      paths.shaded_glass = changed.variant == Variant::shaded_glass;
      if (changed.variant == Variant::lamp_parallelograms) {
        paths.lamps.cover_parallelograms();
      }
    }
    VariantPicture drawn =
        draw_variant(changed.variant, scenes, truth, seconds / static_cast<double>(list.size()));
    std::erase_if(truth.variants,
                  [&](const VariantPicture& old) { return old.variant == drawn.variant; });
    truth.variants.push_back(std::move(drawn));
  }
  return RenderStatus::complete;
}

}  // namespace scenefile
