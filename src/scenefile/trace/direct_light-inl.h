// Lighting at the points of a wavefront. No include guard: included once for each instruction set,
// after shading_points-inl.h.

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

// Keeps what only explain.h needs.
inline void record_arriving(const Arriving& here, F cosine, F mirrored, RecordedLight& recorded,
                            int at) {
  store(here.distance, recorded.distance + at);
  store(here.attenuation, recorded.attenuation + at);
  store(here.spot_factor, recorded.spot_factor + at);
  store(cosine, recorded.n_dot_l + at);
  store(mirrored, recorded.r_dot_v + at);
  recorded.arrives[at / lanes] = static_cast<std::uint8_t>(bits(here.arrives));
}

// The light that arrives from a point of a light; `on_light(at)` selects the point for each lane.
template <typename OnLight>
void find_light(const WavefrontScene& scene, const RenderLight& light, const OnLight& on_light,
                const ShadingPoints& points, DirectLight& out) {
  out.at_a_point = is_at_a_point(light.type);
  out.from = glm::dvec3(light.position);
  for (int at = 0; at < points.count; at += lanes) {
    const V3 normal = load3(points.normal, at);
    const auto [u, v] = on_light(at);
    const Arriving here = arriving(light, load3(points.position, at), u, v);
    const F cosine = dot(normal, here.to_light);
    const F mirrored = mirrored_cosine(normal, here.to_light, cosine, -load3(points.direction, at));
    const M shines = (mirrored > splat(0)) & (load(points.shininess + at) > splat(0));
    const V3 diffuse = load3(points.diffuse, at);
    const M colored = (diffuse.x != splat(0)) | (diffuse.y != splat(0)) | (diffuse.z != splat(0));
    const M asks =
        present_lanes(at, points.count) & here.arrives & (shines | (colored & (cosine > splat(0))));
    store3(here.to_light, out.to_light, at);
    store(scene.course ? here.distance : here.distance * splat(1 - 1e-9), out.end + at);
    store(here.attenuation * here.spot_factor, out.share + at);
    store(max(splat(0), cosine), out.cosine + at);
    store(select(shines, mirrored, splat(0)), out.mirrored + at);
    out.asks[at / lanes] = static_cast<std::uint8_t>(bits(asks));
    if constexpr (recording) {
      record_arriving(here, cosine, mirrored, *out.recorded, at);
    }
  }
}

inline int count_bits(const std::uint8_t* bytes, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    sum += std::popcount(bytes[i]);
  }
  return sum;
}

inline V3 no_color() {
  return {splat(0), splat(0), splat(0)};
}

inline V3 diffuse_share(const ShadingPoints& points, const DirectLight& light, int at) {
  return load(light.cosine + at) * load3(points.diffuse, at);
}

// In the lanes of `shines`.
inline V3 specular_share(const ShadingPoints& points, const DirectLight& light, M shines, int at) {
  const F bright = power(load(light.mirrored + at), load(points.shininess + at), shines);
  return select(shines, bright * load3(points.specular, at), no_color());
}

// The fraction of the light's color that is reflected to the eye: diffuse and specular.
inline V3 reflected_share(const ShadingPoints& points, const DirectLight& light, M asked, int at) {
  const M shines = asked & (load(light.mirrored + at) > splat(0));
  const V3 diffused = diffuse_share(points, light, at);
  return none(shines) ? diffused : diffused + specular_share(points, light, shines, at);
}

inline V3 lit(const ShadingPoints& points, const DirectLight& light, const V3& color, bool dimmed,
              int at) {
  const unsigned sees = light.asks[at / lanes] & ~unsigned{light.blocked[at / lanes]};
  if (sees == 0) {
    return no_color();
  }
  const M seen = of_bits(sees);
  const V3 share = reflected_share(points, light, seen, at) * (load(light.share + at) * color);
  return select(seen, dimmed ? share * load3(light.left, at) : share, no_color());
}

// The same light without shadows, and its diffuse part.
struct LightAovs {
  V3 unshadowed;
  V3 diffused;
};
inline LightAovs light_aovs(const ShadingPoints& points, const DirectLight& light, const V3& color,
                            const V3& arrived, int at) {
  const M asked = of_bits(light.asks[at / lanes]);
  const V3 share = reflected_share(points, light, asked, at);
  const V3 diffuse = diffuse_share(points, light, at);
  const auto part = [](F of, F by, F whole) {
    return select(whole > splat(0), of * by / whole, splat(0));
  };
  return {select(asked, share * (load(light.share + at) * color), no_color()),
          {part(arrived.x, diffuse.x, share.x), part(arrived.y, diffuse.y, share.y),
           part(arrived.z, diffuse.z, share.z)}};
}

// The number of samples of a light for the points of a generation, and their positions: a single
// one, cell centers, or the pattern of each ray.
struct LightSamples {
  const RayQueue& rays;
  const ShadingPoints& points;
  const LightPatterns& patterns;
  const RenderLight& light;
  std::uint32_t index;
  bool grid;
  std::uint32_t count = 1;

  LightSamples(const WavefrontScene& scene, const RayQueue& r, const ShadingPoints& p,
               std::uint32_t i, LightPatterns& to)
      : rays(r),
        points(p),
        patterns(to),
        light(scene.tracer.scene.lights[i]),
        index(i),
        grid(scene.course) {
    if (has_rectangle(light.type)) {
      const std::uint32_t side = course_light_side;
      count = grid ? side * side : rays.key[points.ray[0]].light_samples;
      if (!grid) {
        find_patterns(to);
      }
    }
  }

  void find_patterns(LightPatterns& to) const {
    const int whole = (points.count + lanes - 1) / lanes * lanes;
    for (int k = 0; k < whole; ++k) {
      const SampleKey& key = rays.key[points.ray[k]];
      const PatternSeeds seeds = seeds_of(mixed_bits(key.pattern, 16 + index));
      to.index[k] = key.sample * count;
      to.order[k] = seeds.order;
      to.first[k] = seeds.first;
      to.second[k] = seeds.second;
    }
  }

  // (u, v) of sample i for a chunk of points.
  std::pair<F, F> at(std::uint32_t i, int chunk) const {
    constexpr std::uint32_t side = course_light_side;
    if (!has_rectangle(light.type)) {
      return {splat(0.5), splat(0.5)};
    }
    if (grid) {
      const std::uint32_t row = i / side;
      return {splat((i % side + 0.5) / side), splat((row + 0.5) / side)};
    }
    alignas(64) double u[lanes];
    alignas(64) double v[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const int k = chunk + lane;
      const PatternPoint p = pattern_point(
          patterns.index[k] + i, {patterns.order[k], patterns.first[k], patterns.second[k]});
      u[lane] = p.x * pattern_unit;
      v[lane] = p.y * pattern_unit;
    }
    return {load(u), load(v)};
  }
};

// Marks rays whose points see a light partially, by the number of visible samples.
inline void mark_penumbras(const LightSamples& samples, const F* seen, RayNode* nodes) {
  alignas(64) double numbers[lanes];
  for (int k = 0; k < samples.points.count; ++k) {
    if (k % lanes == 0) {
      store(seen[k / lanes], numbers);
    }
    const double of_them = numbers[k % lanes];
    RayNode& node = nodes[samples.rays.node[samples.points.ray[k]]];
    node.penumbra = node.penumbra || (of_them != 0 && of_them != samples.count);
  }
}

// Stores the light that the points of camera rays reflect from a light.
inline void store_light_aovs(const LightSamples& samples, const V3* sums, const LightAovs* terms,
                             const AovOutput& aovs) {
  const std::size_t kept = aovs.lights.size();
  const F count = splat(samples.count);
  const bool area = has_rectangle(samples.light.type);
  alignas(64) double lit[3][lanes];
  alignas(64) double unshadowed[3][lanes];
  alignas(64) double diffused[3][lanes];
  for (int k = 0; k < samples.points.count; ++k) {
    const int lane = k % lanes;
    if (lane == 0) {
      const int c = k / lanes;
      store_rows(sums[c] / count, lit);
      store_rows(terms[c].unshadowed / count, unshadowed);
      store_rows(terms[c].diffused / count, diffused);
    }
    const std::uint32_t sample = samples.rays.node[samples.points.ray[k]];
    AovSample& to = aovs.samples[sample];
    to.lit += lane_of(lit, lane);
    to.unshadowed += lane_of(unshadowed, lane);
    if (area) {
      to.diffused += lane_of(diffused, lane);
    }
    for (std::size_t i = 0; i < kept; ++i) {
      if (aovs.lights[i] == samples.index) {
        aovs.light_colors[sample * kept + i] = lane_of(lit, lane);
      }
    }
  }
}

// Stores for each point whether it sees the light.
inline void set_visible_lights(const DirectLight& light, int chunks, ShadingPoints& points) {
  const std::uint32_t place = light.index % 32;
  for (int c = 0; c < chunks; ++c) {
    const unsigned sees = light.asks[c] & ~unsigned{light.blocked[c]};
    for (int i = 0; i < lanes; ++i) {
      points.visible_lights[c * lanes + i] ^= (sees >> i & 1u) << place;
    }
  }
}

// Keeps what only explain.h needs.
inline void record_reflected(const ShadingPoints& points, const V3& reflected, DirectLight& light,
                             int at) {
  const M shines = load(light.mirrored + at) > splat(0);
  store3(diffuse_share(points, light, at), light.recorded->diffuse, at);
  store3(specular_share(points, light, shines, at), light.recorded->specular, at);
  store3(reflected, light.recorded->contribution, at);
}

// `aovs`: null for secondary rays, and if none are wanted.
inline void add_light(const WavefrontScene& scene, const LightSamples& samples,
                      WavefrontMemory& memory, RayCounts& counts, const AovOutput* aovs) {
  const Tracer& tracer = scene.tracer;
  const bool shadows = tracer.options.features.shadows && tracer.options.mode == Mode::ray;
  const bool dimmed = shadows && scene.transmissive_shadows;
  ShadingPoints& points = memory.points;
  DirectLight& light = memory.light;
  const int chunks = (points.count + lanes - 1) / lanes;
  const V3 color = splat3(samples.light.color);
  alignas(64) V3 sums[queue_rays / lanes];
  alignas(64) F seen[queue_rays / lanes];
  alignas(64) LightAovs terms[wavefront_samples / lanes];  // of camera rays
  for (std::uint32_t i = 0; i < samples.count; ++i) {
    find_light(
        scene, samples.light, [&](int at) { return samples.at(i, at); }, points, light);
    std::fill_n(light.blocked, chunks, std::uint8_t{0});
    if (shadows) {
      counts.shadow += static_cast<std::uint64_t>(count_bits(light.asks, chunks));
      find_blocked(scene, points, light);
    }
    if (!scene.course && samples.count == 1) {
      set_visible_lights(light, chunks, points);
    }
    for (int c = 0; c < chunks; ++c) {
      const V3 one = lit(points, light, color, dimmed, c * lanes);
      if constexpr (recording) {
        record_reflected(points, one, light, c * lanes);
      }
      sums[c] = i == 0 ? one : sums[c] + one;
      if (aovs != nullptr) {
        const LightAovs more = light_aovs(points, light, color, one, c * lanes);
        terms[c] = i == 0 ? more
                          : LightAovs{terms[c].unshadowed + more.unshadowed,
                                      terms[c].diffused + more.diffused};
      }
      if (samples.count > 1) {
        const M sees = (one.x != splat(0)) | (one.y != splat(0)) | (one.z != splat(0));
        seen[c] = (i == 0 ? splat(0) : seen[c]) + select(sees, splat(1), splat(0));
      }
    }
    if constexpr (recording) {
      record_light_sample(scene, samples.rays, memory, shadows);
    }
  }
  for (int c = 0; c < chunks; ++c) {
    const V3 mean = sums[c] / splat(samples.count);
    store3(load3(points.color, c * lanes) + mean, points.color, c * lanes);
    if constexpr (recording) {
      store3(mean, light.recorded->contribution, c * lanes);
    }
  }
  if constexpr (recording) {
    record_light_sums(samples.rays, points, light, *memory.recorder);
  }
  if (samples.count > 1) {
    mark_penumbras(samples, seen, memory.nodes.data());
  }
  if (aovs != nullptr) {
    store_light_aovs(samples, sums, terms, *aovs);
  }
}

/// Adds the light that the points reflect to the eye.
inline void find_lights(const WavefrontScene& scene, const RayQueue& rays, WavefrontMemory& memory,
                        RayCounts& counts, const AovOutput* aovs) {
  if (memory.points.count == 0) {
    return;
  }
  const std::vector<RenderLight>& lights = scene.tracer.scene.lights;
  memory.light.incoherent = memory.hits.incoherent;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    memory.light.index = i;
    const bool shines = scene.tracer.uses(lights[i]);
    if constexpr (recording) {
      record_light(rays, memory.points, i, shines, *memory.recorder);
    }
    if (shines) {
      const LightSamples samples(scene, rays, memory.points, i, memory.light.patterns);
      add_light(scene, samples, memory, counts, aovs);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
