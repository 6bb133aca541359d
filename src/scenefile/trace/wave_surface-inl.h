// The surfaces at the points that the rays of a wave hit. No guard: included once for each
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

inline bool all_one(const Part* const (&parts)[lanes]) {
  return std::all_of(parts, parts + lanes, [&](const Part* part) { return part == parts[0]; });
}

inline ChunkParts chunk_parts(const Part* const (&parts)[lanes]) {
  if (all_one(parts)) {
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
  put(color_of(material.specular), points.specular, i);
  put(color_of(material.ambient), points.color, i);
  points.shininess[i] = material.shininess;
}

// What ray r of a wave hit, in full.
inline Hit hit_of(const WaveScene& scene, const WaveHits& hits, std::uint32_t r, const Ray& ray) {
  if (hits.part[r] < 0) {
    return hits.others[r];
  }
  const Part& part = scene.root[static_cast<std::size_t>(hits.part[r])];
  Hit hit;
  hit.t = hits.t[r];
  hit.shape = part.shape;
  hit.face = static_cast<Face>(hits.face[r]);
  hit.material = part.material;
  hit.source = part.source;
  hit.part = &part;
  hit.object_from_world = DAffine(part.part_from_group);
  hit.object_point = hit.object_from_world.point(ray.origin + hit.t * ray.direction);
  return hit;
}

// One point by the functions for one.
inline void surface_of_one(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                           bool lit, WavePoints& points, int i) {
  const Tracer& tracer = scene.tracer;
  const std::uint32_t r = points.ray[i];
  const Ray ray{get(rays.origin, r), get(rays.direction, r)};
  const Hit hit = hit_of(scene, hits, r, ray);
  SurfacePoint& point = points.surface[i];
  point = surface_point(tracer.scene, tracer.assets, ray, hit, !scene.course);
  points.known[i] = true;
  const double width = rays.cone[r].width_at(hit.t);
  Color diffuse(0);
  if (lit) {
    apply_bump(tracer, point, ray.direction, width);
    diffuse = diffuse_color(tracer, point, ray.direction, width, nullptr);
  }
  put(point.position, points.position, i);
  put(point.normal, points.normal, i);
  put(point.geometric, points.geometric, i);
  put_material(scene.materials[hit.material], diffuse, points, i);
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
  u = select(round, around_u(around), u);
  v = select(round, within(p.y + splat(0.5), 0, 1), v);
  v = select(ball, sphere_v(p.y, around), v);
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
  alignas(32) std::int32_t rgb[lanes] = {};
  store(splat(3) * (y * chunk.width + x), offsets);
  for (int i = 0; i < lanes; ++i) {
    if (chunk.texture[i] != nullptr) {
      const std::uint8_t* const texel =
          chunk.texture[i]->rgb.data() + static_cast<std::size_t>(offsets[i]);
      rgb[i] = texel[0] | texel[1] << 8 | texel[2] << 16;
    }
  }
  return {share_of_255(load_byte<0>(rgb)), share_of_255(load_byte<1>(rgb)),
          share_of_255(load_byte<2>(rgb))};
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

// The materials of a chunk; whether one of them has a texture.
inline bool shape_materials(const WaveScene& scene, const Part* const (&parts)[lanes],
                            WavePoints& points, int at) {
  const WaveMaterial& first = scene.materials[parts[0]->material];
  if (all_one(parts)) {
    std::fill_n(points.material + at, lanes, &first);
    store3(splat_row(first.diffuse), points.diffuse, at);
    store3(splat_row(first.specular), points.specular, at);
    store3(splat_row(first.ambient), points.color, at);
    store(splat(first.shininess), points.shininess + at);
    return first.texture != nullptr;
  }
  bool textured = false;
  for (int i = 0; i < lanes; ++i) {
    const WaveMaterial& material = scene.materials[parts[i]->material];
    put_material(material, color_of(material.diffuse), points, at + i);
    textured = textured || material.texture != nullptr;
  }
  return textured;
}

// Of shapes of the root group alone.
inline void shape_surfaces(const WaveScene& scene, const WaveHits& hits, bool lit,
                           WavePoints& points, int at) {
  const Part* parts[lanes];
  alignas(64) double faces[lanes];
  for (int i = 0; i < lanes; ++i) {
    const std::uint32_t r = points.ray[at + i];
    parts[i] = &scene.root[static_cast<std::size_t>(hits.part[r])];
    faces[i] = hits.face[r];
  }
  const bool textured = shape_materials(scene, parts, points, at) && lit;
  const ChunkParts chunk = chunk_parts(parts);
  const V3 position = load3(points.normal, at) + load(points.t + at) * load3(points.direction, at);
  const V3 object_point = chunk.map.point(position);
  const V3 normal = world_normal(chunk.map, object_normal(chunk.shape, load(faces), object_point));
  store3(position, points.position, at);
  store3(normal, points.normal, at);
  store3(normal, points.geometric, at);
  if (textured) {
    texture_chunk(scene, chunk.shape, load(faces), object_point, points, at);
  }
}

/// Fills all but the light that comes from the points. `lit`: with bumps and textures.
inline void find_surfaces(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                          bool lit, WavePoints& points) {
  if (points.count == 0) {
    return;
  }
  gather_rays(rays, hits, points);
  for (int at = 0; at < points.count; at += lanes) {
    const bool shapes = std::all_of(points.ray + at, points.ray + at + lanes,
                                    [&](std::uint32_t r) { return hits.part[r] >= 0; });
    if (shapes) {
      shape_surfaces(scene, hits, lit, points, at);
    }
    for (int i = at; i < at + lanes; ++i) {
      points.known[i] = false;
      if (!shapes || (lit && points.material[i]->by_footprint)) {
        surface_of_one(scene, rays, hits, lit, points, i);
      }
    }
    const V3 position = load3(points.position, at);
    store(scene.course ? splat(course_offset) : fine_offset(position, load(points.t + at)),
          points.offset + at);
  }
}

}  // namespace scenefile::SCENEFILE_LANES
