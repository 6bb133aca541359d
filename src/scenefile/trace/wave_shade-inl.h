// The light at the points that the rays of a wave hit. No guard: included once for each
// instruction set, behind wave_search-inl.h.

#include "scenefile/trace/wave_memory.h"

namespace scenefile::SCENEFILE_LANES {

// The normal in object space of the shapes of a chunk.
inline V3 object_normal(F shape, F face, const V3& p) {
  const auto is = [&](Face a, Face b) { return (face == number_of(a)) | (face == number_of(b)); };
  const auto axis = [&](M positive, M negative) {
    return select(positive, splat(1), select(negative, splat(-1), splat(0)));
  };
  V3 normal{axis(is(Face::pos_x, Face::pos_x), is(Face::neg_x, Face::neg_x)),
            axis(is(Face::pos_y, Face::top), is(Face::neg_y, Face::bottom)),
            axis(is(Face::pos_z, Face::pos_z), is(Face::neg_z, Face::neg_z))};
  const M round = face == number_of(Face::side);
  if (none(round)) {
    return normal;
  }
  const Around around = around_axis(p);
  const auto sides = [&](Shape kind) { return round & (shape == splat(static_cast<int>(kind))); };
  normal = select(sides(Shape::sphere), sphere_normal(p, around), normal);
  normal = select(sides(Shape::cylinder), cylinder_normal(around), normal);
  return select(sides(Shape::cone), cone_normal(around), normal);
}

inline V3 world_normal(const Map& object_from_world, const V3& normal) {
  const V3 n{dot(object_from_world.x, normal), dot(object_from_world.y, normal),
             dot(object_from_world.z, normal)};
  const F size = length(n);
  const M fine = (size > splat(0)) & finite(size);
  return select(fine, n / size, V3{splat(0), splat(1), splat(0)});
}

// The parts that a chunk of points lies on, as what is wanted of them in lanes.
struct ChunkParts {
  Map map;
  F shape;
};

inline ChunkParts chunk_parts(const Part* const (&parts)[lanes]) {
  if (std::all_of(parts, parts + lanes, [&](const Part* part) { return part == parts[0]; })) {
    return {splat_map(parts[0]->part_from_group), splat(static_cast<int>(parts[0]->shape))};
  }
  alignas(64) double m[12][lanes];
  alignas(64) double shape[lanes];
  for (int i = 0; i < lanes; ++i) {
    const Affine& map = parts[i]->part_from_group;
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        m[3 * column + row][i] = map.linear[column][row];
      }
      m[9 + column][i] = map.offset[column];
    }
    shape[i] = static_cast<int>(parts[i]->shape);
  }
  const auto vector = [&](int first) {
    return V3{load(m[first]), load(m[first + 1]), load(m[first + 2])};
  };
  return {{vector(0), vector(3), vector(6), vector(9)}, load(shape)};
}

inline Color texture_color(const WaveScene& scene, const WaveMaterial& material,
                           const glm::dvec2& uv) {
  return scene.tracer.options.features.texture_filter
             ? lookup_course_filter(*material.texture, material.material->texture, uv)
             : lookup_nearest(*material.texture, material.material->texture, uv);
}

inline void put(const Color& color, WaveVectors& to, int at) {
  to.x[at] = color.x;
  to.y[at] = color.y;
  to.z[at] = color.z;
}

inline Color get(const WaveVectors& from, int at) {
  return {from.x[at], from.y[at], from.z[at]};
}

// Copies what the points need of rays and hits, and pads the last chunk with copies of the last.
inline void gather_rays(const WaveRays& rays, const WaveHits& hits, WavePoints& points) {
  const int whole = (points.count + lanes - 1) / lanes * lanes;
  for (int i = points.count; i < whole; ++i) {
    points.ray[i] = points.ray[points.count - 1];
  }
  for (int i = 0; i < whole; ++i) {
    const std::uint32_t r = points.ray[i];
    points.direction.x[i] = rays.direction.x[r];
    points.direction.y[i] = rays.direction.y[r];
    points.direction.z[i] = rays.direction.z[r];
    points.t[i] = hits.t[r];
    points.normal.x[i] = rays.origin.x[r];
    points.normal.y[i] = rays.origin.y[r];
    points.normal.z[i] = rays.origin.z[r];
  }
}

inline void put_material(const WaveMaterial& material, const Color& diffuse, WavePoints& points,
                         int i) {
  points.material[i] = &material;
  put(diffuse, points.diffuse, i);
  put({material.specular[0], material.specular[1], material.specular[2]}, points.specular, i);
  put({material.ambient[0], material.ambient[1], material.ambient[2]}, points.color, i);
  points.shininess[i] = material.shininess;
}

inline Color plain_diffuse(const WaveMaterial& m) {
  return {m.diffuse[0], m.diffuse[1], m.diffuse[2]};
}

// One point by the functions for one.
inline void surface_of_other(const WaveScene& scene, const Hit& hit, const Ray& ray,
                             WavePoints& points, int i) {
  const Tracer& tracer = scene.tracer;
  const SurfacePoint point = surface_point(tracer.scene, tracer.assets, ray, hit, !tracer.course());
  const WaveMaterial& material = scene.materials[hit.material];
  Color diffuse = plain_diffuse(material);
  if (material.texture != nullptr) {
    diffuse = glm::mix(diffuse, texture_color(scene, material, point.object.uv), material.blend);
  }
  put(point.position, points.position, i);
  put(point.normal, points.normal, i);
  put_material(material, diffuse, points, i);
}

// (u, v) of the shapes of a chunk, in the lanes of the mask.
inline void object_uv(F shape, F face, const V3& p, M wanted, F& u, F& v) {
  const auto is = [&](Face f) { return face == number_of(f); };
  const M on_side = is(Face::pos_x) | is(Face::neg_x) | is(Face::pos_z) | is(Face::neg_z);
  const M below = is(Face::bottom) | is(Face::neg_y);
  F along = select(is(Face::pos_x), -p.z, p.x);
  along = select(is(Face::neg_x), p.z, select(is(Face::neg_z), -p.x, along));
  u = within(along + splat(0.5), 0, 1);
  v = within(select(on_side, p.y, select(below, p.z, -p.z)) + splat(0.5), 0, 1);
  const M round = wanted & is(Face::side);
  if (none(round)) {
    return;
  }
  const Around around = around_axis(p);
  const M ball = round & (shape == splat(static_cast<int>(Shape::sphere)));
  u = select(round, around_u(around, round), u);
  v = select(round, within(p.y + splat(0.5), 0, 1), v);
  v = select(ball, sphere_v(p.y, around, ball), v);
}

// The texels of a chunk: of each lane a texture, and how often it repeats.
struct ChunkTextures {
  const Texture* texture[lanes] = {};
  M used = no_lanes();
  F width, height, repeat_u, repeat_v, blend;
};

inline ChunkTextures chunk_textures(const WavePoints& points, int at) {
  ChunkTextures chunk;
  alignas(64) double numbers[5][lanes] = {};
  unsigned used = 0;
  for (int i = 0; i < lanes; ++i) {
    const WaveMaterial& material = *points.material[at + i];
    if (material.texture == nullptr) {
      continue;
    }
    used |= 1u << i;
    chunk.texture[i] = material.texture;
    numbers[0][i] = material.texture->width;
    numbers[1][i] = material.texture->height;
    numbers[2][i] = material.material->texture.repeat_u;
    numbers[3][i] = material.material->texture.repeat_v;
    numbers[4][i] = material.blend;
  }
  chunk.used = of_bits(used);
  chunk.width = load(numbers[0]);
  chunk.height = load(numbers[1]);
  chunk.repeat_u = load(numbers[2]);
  chunk.repeat_v = load(numbers[3]);
  chunk.blend = load(numbers[4]);
  return chunk;
}

// Colors of texels at whole positions.
inline V3 texels(const ChunkTextures& chunk, F x, F y) {
  alignas(64) double offsets[lanes];
  alignas(32) std::int32_t rgb[3][lanes] = {};
  store(splat(3) * (y * chunk.width + x), offsets);
  for (int i = 0; i < lanes; ++i) {
    if (chunk.texture[i] != nullptr) {
      const std::uint8_t* const texel =
          chunk.texture[i]->rgb.data() + static_cast<std::size_t>(offsets[i]);
      rgb[0][i] = texel[0];
      rgb[1][i] = texel[1];
      rgb[2][i] = texel[2];
    }
  }
  return V3{load_whole(rgb[0]), load_whole(rgb[1]), load_whole(rgb[2])} / splat(255);
}

// A whole position within a texture that repeats.
inline F wrapped(F index, F size) {
  const F inside = index - size * down(index / size);
  return select(inside >= splat(0), least(inside, size - splat(1)), splat(0));
}

inline V3 mix(const V3& a, const V3& b, F share) {
  return (splat(1) - share) * a + share * b;
}

inline V3 texture_at(const WaveScene& scene, const ChunkTextures& chunk, F u, F v) {
  const F x = u * chunk.repeat_u * chunk.width;
  const F y = (splat(1) - v) * chunk.repeat_v * chunk.height;
  const F left = down(x);
  const F top = down(y);
  const F x0 = wrapped(left, chunk.width);
  const F y0 = wrapped(top, chunk.height);
  if (!scene.tracer.options.features.texture_filter) {
    return texels(chunk, x0, y0);
  }
  const auto next = [](F at, F size) {
    return select(at + splat(1) == size, splat(0), at + splat(1));
  };
  const F x1 = next(x0, chunk.width);
  const F y1 = next(y0, chunk.height);
  const V3 above = mix(texels(chunk, x0, y0), texels(chunk, x1, y0), x - left);
  const V3 below = mix(texels(chunk, x0, y1), texels(chunk, x1, y1), x - left);
  return mix(above, below, y - top);
}

inline void texture_chunk(const WaveScene& scene, F shape, F face, const V3& p, WavePoints& points,
                          int at) {
  const ChunkTextures chunk = chunk_textures(points, at);
  F u;
  F v;
  object_uv(shape, face, p, chunk.used, u, v);
  const V3 plain = load3(points.diffuse, at);
  const V3 textured = mix(plain, texture_at(scene, chunk, u, v), chunk.blend);
  store3(select(chunk.used, textured, plain), points.diffuse, at);
}

// Of shapes of the root group alone.
inline void shape_surfaces(const WaveScene& scene, const WaveHits& hits, WavePoints& points,
                           int at) {
  const Parts& all = scene.tracer.accelerator.parts();
  const std::vector<Part>& group = all.groups[all.root].parts;
  const Part* parts[lanes];
  alignas(64) double faces[lanes];
  bool textured = false;
  for (int i = 0; i < lanes; ++i) {
    const std::uint32_t r = points.ray[at + i];
    parts[i] = &group[static_cast<std::size_t>(hits.part[r])];
    faces[i] = hits.face[r];
    const WaveMaterial& material = scene.materials[parts[i]->material];
    put_material(material, plain_diffuse(material), points, at + i);
    textured = textured || material.texture != nullptr;
  }
  const ChunkParts chunk = chunk_parts(parts);
  const V3 position = load3(points.normal, at) + load(points.t + at) * load3(points.direction, at);
  const V3 object_point = chunk.map.point(position);
  store3(position, points.position, at);
  store3(world_normal(chunk.map, object_normal(chunk.shape, load(faces), object_point)),
         points.normal, at);
  if (textured) {
    texture_chunk(scene, chunk.shape, load(faces), object_point, points, at);
  }
}

/// Fills all but the light that comes from the points.
inline void find_surfaces(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                          WavePoints& points) {
  if (points.count == 0) {
    return;
  }
  gather_rays(rays, hits, points);
  for (int at = 0; at < points.count; at += lanes) {
    const bool shapes = std::all_of(points.ray + at, points.ray + at + lanes,
                                    [&](std::uint32_t r) { return hits.part[r] >= 0; });
    if (shapes) {
      shape_surfaces(scene, hits, points, at);
      continue;
    }
    for (int i = at; i < at + lanes; ++i) {
      const std::uint32_t r = points.ray[i];
      const Ray ray{get(points.normal, i), get(points.direction, i)};
      surface_of_other(scene, hits.others[r], ray, points, i);
    }
  }
}

// What arrives of one light at (u, v) of it.
inline void find_light(const RenderLight& light, double u, double v, const WavePoints& points,
                       WaveLight& out) {
  for (int at = 0; at < points.count; at += lanes) {
    const V3 normal = load3(points.normal, at);
    const Arriving here = arriving(light, load3(points.position, at), splat(u), splat(v), false);
    const F cosine = dot(normal, here.to_light);
    const F mirrored = mirrored_cosine(normal, here.to_light, cosine, -load3(points.direction, at));
    const M shines = (mirrored > splat(0)) & (load(points.shininess + at) > splat(0));
    const V3 diffuse = load3(points.diffuse, at);
    const M colored = (diffuse.x != splat(0)) | (diffuse.y != splat(0)) | (diffuse.z != splat(0));
    const M asks =
        present_lanes(at, points.count) & here.arrives & (shines | (colored & (cosine > splat(0))));
    store3(here.to_light, out.to_light, at);
    store(here.distance, out.end + at);
    store(here.attenuation * here.spot_factor, out.share + at);
    store(greatest(splat(0), cosine), out.cosine + at);
    store(select(shines, mirrored, splat(0)), out.mirrored + at);
    out.asks[at / lanes] = static_cast<std::uint8_t>(bits(asks));
  }
}

inline int count_bits(const std::uint8_t* bytes, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) {
    sum += std::popcount(bytes[i]);
  }
  return sum;
}

inline V3 lit(const WavePoints& points, const WaveLight& light, const V3& color, int at) {
  const unsigned sees = light.asks[at / lanes] & ~unsigned{light.blocked[at / lanes]};
  const V3 none_at_all = {splat(0), splat(0), splat(0)};
  if (sees == 0) {
    return none_at_all;
  }
  const M seen = of_bits(sees);
  const F mirrored = load(light.mirrored + at);
  const M shines = seen & (mirrored > splat(0));
  V3 share = load(light.cosine + at) * load3(points.diffuse, at);
  if (any(shines)) {
    const F bright = power(mirrored, load(points.shininess + at), shines);
    const V3 shining = bright * load3(points.specular, at);
    share = share + select(shines, shining, none_at_all);
  }
  return select(seen, share * (load(light.share + at) * color), none_at_all);
}

/// Adds what the lights of the scene send to the eye by way of the points. `rays_apart`: those that
/// led there.
inline void find_lights(const WaveScene& scene, bool rays_apart, WavePoints& points,
                        WaveLight& light, RayCounts& counts) {
  const Tracer& tracer = scene.tracer;
  const bool shadows = tracer.options.features.shadows && tracer.options.mode == Mode::ray;
  const int chunks = (points.count + lanes - 1) / lanes;
  light.apart = rays_apart;
  for (const RenderLight& from : tracer.scene.lights) {
    if (!shines_in(tracer, from)) {
      continue;
    }
    const V3 color = splat3(from.color);
    const int side = from.type == LightType::area ? static_cast<int>(course_light_side) : 1;
    WaveVectors* const sum = &points.color;
    alignas(64) V3 sums[wave_rays / lanes];
    for (int i = 0; i < side * side; ++i) {
      find_light(from, (i % side + 0.5) / side, (i / side + 0.5) / side, points, light);
      std::fill_n(light.blocked, chunks, std::uint8_t{0});
      if (shadows) {
        counts.shadow += static_cast<std::uint64_t>(count_bits(light.asks, chunks));
        find_blocked(scene, points, light);
      }
      for (int c = 0; c < chunks; ++c) {
        const V3 one = lit(points, light, color, c * lanes);
        sums[c] = i == 0 ? one : sums[c] + one;
      }
    }
    for (int c = 0; c < chunks; ++c) {
      store3(load3(*sum, c * lanes) + sums[c] / splat(side * side), *sum, c * lanes);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
