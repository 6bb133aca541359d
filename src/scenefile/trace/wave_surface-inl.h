// The surfaces at the points hit by the rays of a wave. No include guard: included once for each
// instruction set, after wave_search-inl.h.

#include "scenefile/trace/wave_memory.h"

#include <optional>

namespace scenefile::SCENEFILE_LANES {

// The object-space normal for the shapes of a chunk.
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
  static_assert(shape_count == 5, "a new shape needs its normal here and its (u, v) below");
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

// The parts of a chunk of points, in lanes.
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

// Copies data of rays and hits to the points, and pads the last chunk with copies of the last
// point.
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

inline RayDifferential differential_of(const WaveRays& rays, std::uint32_t r) {
  const int i = static_cast<int>(r);
  return {{get(rays.origin_steps.x, i), get(rays.origin_steps.y, i)},
          {get(rays.direction_steps.x, i), get(rays.direction_steps.y, i)}};
}

// The same for a chunk of rays.
inline V3 gather3(const WaveVectors& from, const std::uint32_t* ray) {
  alignas(64) double rows[3][lanes];
  for (int i = 0; i < lanes; ++i) {
    rows[0][i] = from.x[ray[i]];
    rows[1][i] = from.y[ray[i]];
    rows[2][i] = from.z[ray[i]];
  }
  return {load(rows[0]), load(rows[1]), load(rows[2])};
}

inline Steps gather_steps(const WaveSteps& from, const std::uint32_t* ray) {
  return {gather3(from.x, ray), gather3(from.y, ray)};
}

// The complete Hit of ray r of a wave.
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

// (u, v) for the shapes of a chunk, in the lanes of the mask.
inline void object_uv(F shape, F face, const V3& p, M wanted, F& u, F& v) {
  const auto is = [&](Face f) { return face == number_of(f); };
  const M on_side = is(Face::pos_x) | is(Face::neg_x) | is(Face::pos_z) | is(Face::neg_z);
  const M below = is(Face::bottom) | is(Face::neg_y);
  F along = select(is(Face::pos_x), -p.z, p.x);
  along = select(is(Face::neg_x), p.z, select(is(Face::neg_z), -p.x, along));
  u = clamp(along + splat(0.5), 0, 1);
  v = clamp(select(on_side, p.y, select(below, p.z, -p.z)) + splat(0.5), 0, 1);
  const M round = wanted & is(Face::side);
  if (none(round)) {
    return;
  }
  const Around around = around_axis(p);
  const M ball = round & (shape == splat(static_cast<int>(Shape::sphere)));
  u = select(round, around_u(around), u);
  v = select(round, clamp(p.y + splat(0.5), 0, 1), v);
  v = select(ball, sphere_v(p.y, around), v);
}

// Object-space data of a chunk of points on shapes.
struct ChunkShapes {
  Map map;
  F shape;
  F face;
  V3 point;
  V3 normal;  // in object space
};

inline void store_uv(const ChunkShapes& shapes, WavePoints& points, int at) {
  F u;
  F v;
  object_uv(shapes.shape, shapes.face, shapes.point, !no_lanes(), u, v);
  store(u, points.u + at);
  store(v, points.v + at);
}

// Keeps what only explain.h needs of shapes.
inline void note_shapes(const ChunkShapes& shapes, WavePointNotes& notes, int at) {
  store3(shapes.normal, notes.object_normal, at);
  std::fill_n(notes.has_uv + at, lanes, true);
  std::fill_n(notes.bumped + at, lanes, false);
  std::fill_n(notes.textured + at, lanes, false);
}

inline void note_texture(const V3& color, M used, WavePointNotes& notes, int at) {
  store3(color, notes.texture, at);
  for (int i = 0; i < lanes; ++i) {
    notes.textured[at + i] = (bits(used) >> i & 1) != 0;
  }
}

inline void note_one(const SurfacePoint& point, bool bumped, const std::optional<Color>& texture,
                     WavePointNotes& notes, int i) {
  put(point.object.normal, notes.object_normal, i);
  notes.has_uv[i] = point.has_uv;
  notes.bumped[i] = bumped;
  notes.textured[i] = texture.has_value();
  put(texture.value_or(Color(0)), notes.texture, i);
}

// Computes one point with the scalar code.
inline void surface_of_one(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                           bool lit, WavePoints& points, int i) {
  const Tracer& tracer = scene.tracer;
  const std::uint32_t r = points.ray[i];
  const Ray ray{get(rays.origin, r), get(rays.direction, r)};
  const Hit hit = hit_of(scene, hits, r, ray);
  SurfacePoint point = surface_point(tracer.scene, tracer.assets, ray, hit, !scene.course);
  PixelSteps steps;
  if (scene.by_footprint) {
    steps = arriving_steps(differential_of(rays, r), ray.direction, point);
    const PixelSteps turns = normal_turns(point, steps);
    put(steps.x, points.steps.x, i);
    put(steps.y, points.steps.y, i);
    put(turns.x, points.turns.x, i);
    put(turns.y, points.turns.y, i);
  }
  Color diffuse(0);
  const glm::dvec3 unbumped = point.normal;
  std::optional<Color> texture;
  if (lit) {
    const int grid = rays.key[r].texture_grid;
    apply_bump(tracer, point, steps, grid);
    texture = texture_color(tracer, point, steps, grid);
    diffuse = diffuse_color(tracer, *point.material, texture);
  }
  if constexpr (recording) {
    note_one(point, point.normal != unbumped, texture, *points.notes, i);
  }
  put(point.position, points.position, i);
  put(point.normal, points.normal, i);
  put(point.geometric, points.geometric, i);
  points.u[i] = point.object.uv.x;
  points.v[i] = point.object.uv.y;
  put_material(scene.materials[hit.material], diffuse, points, i);
}

// The textures of a chunk: one for each lane, with its repeats.
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

// Looks up texels at integer positions, in textures of these widths.
inline V3 texels(const Texture* const (&texture)[lanes], F width, F x, F y) {
  alignas(64) double offsets[lanes];
  alignas(32) std::int32_t rgb[lanes] = {};
  store(splat(3) * (y * width + x), offsets);
  for (int i = 0; i < lanes; ++i) {
    if (texture[i] != nullptr) {
      const std::uint8_t* const texel =
          texture[i]->rgb.data() + static_cast<std::size_t>(offsets[i]);
      rgb[i] = texel[0] | texel[1] << 8 | texel[2] << 16;
    }
  }
  return {share_of_255(load_byte<0>(rgb)), share_of_255(load_byte<1>(rgb)),
          share_of_255(load_byte<2>(rgb))};
}

inline V3 texture_at(const WaveScene& scene, const ChunkTextures& chunk, F u, F v) {
  const F x = texel_x(u, chunk.repeat_u, chunk.width);
  const F y = texel_y(v, chunk.repeat_v, chunk.height);
  const auto at = [&](F column, F row) { return texels(chunk.texture, chunk.width, column, row); };
  if (!scene.tracer.options.features.texture_filter) {
    return at(wrapped(floor(x), chunk.width), wrapped(floor(y), chunk.height));
  }
  return bilinear(chunk.width, chunk.height, x, y, at);
}

// The textures of a chunk that are filtered over footprints, with the interface for filtered().
struct ChunkPyramids {
  const Pyramid* pyramid[lanes] = {};
  M used = no_lanes();
  F count, width, height, repeat_u, repeat_v, blend, grid;

  F levels() const { return count; }

  V3 smooth(F level, M wanted, F x, F y) const {
    const Texture* texture[lanes] = {};
    alignas(64) double numbers[3][lanes];
    store(level, numbers[0]);
    const unsigned lanes_wanted = bits(wanted);
    for (int i = 0; i < lanes; ++i) {
      numbers[1][i] = numbers[2][i] = 1;
      if ((lanes_wanted >> i & 1) != 0) {
        texture[i] = &pyramid[i]->level(static_cast<int>(numbers[0][i]));
        numbers[1][i] = texture[i]->width;
        numbers[2][i] = texture[i]->height;
      }
    }
    const F columns = load(numbers[1]);
    const F rows = load(numbers[2]);
    return bilinear(columns, rows, x * (columns / width) - splat(0.5),
                    y * (rows / height) - splat(0.5),
                    [&](F column, F row) { return texels(texture, columns, column, row); });
  }
};

inline ChunkPyramids chunk_pyramids(const WaveRays& rays, const WavePoints& points, int at) {
  ChunkPyramids chunk;
  alignas(64) double numbers[7][lanes];
  unsigned used = 0;
  for (int i = 0; i < lanes; ++i) {
    const WaveMaterial& material = *points.material[at + i];
    const bool has = material.pyramid != nullptr;
    used |= has ? 1u << i : 0u;
    chunk.pyramid[i] = material.pyramid;
    numbers[0][i] = has ? material.pyramid->levels() : 1;
    numbers[1][i] = has ? material.pyramid->level(0).width : 1;
    numbers[2][i] = has ? material.pyramid->level(0).height : 1;
    numbers[3][i] = has ? material.material->texture.repeat_u : 1;
    numbers[4][i] = has ? material.material->texture.repeat_v : 1;
    numbers[5][i] = material.blend;
    numbers[6][i] = rays.key[points.ray[at + i]].texture_grid;
  }
  chunk.used = of_bits(used);
  chunk.count = load(numbers[0]);
  chunk.width = load(numbers[1]);
  chunk.height = load(numbers[2]);
  chunk.repeat_u = load(numbers[3]);
  chunk.repeat_v = load(numbers[4]);
  chunk.blend = load(numbers[5]);
  chunk.grid = load(numbers[6]);
  return chunk;
}

inline void filtered_texture_chunk(const ChunkShapes& shapes, const Steps& steps,
                                   const WaveRays& rays, WavePoints& points, int at) {
  const ChunkPyramids chunk = chunk_pyramids(rays, points, at);
  F u;
  F v;
  object_uv(shapes.shape, shapes.face, shapes.point, chunk.used, u, v);
  const auto uv_step = [&](const V3& step) {
    return shape_uv_step(shapes.shape, shapes.face, shapes.point, shapes.map.vector(step));
  };
  const TexelFootprint footprint =
      texel_footprint(uv_step(steps.x), uv_step(steps.y), chunk.repeat_u, chunk.repeat_v,
                      chunk.width, chunk.height);
  const V3 color =
      filtered(chunk, texel_x(u, chunk.repeat_u, chunk.width),
               texel_y(v, chunk.repeat_v, chunk.height), footprint, chunk.grid, chunk.used);
  const V3 plain = load3(points.diffuse, at);
  store3(select(chunk.used, mix(plain, color, chunk.blend), plain), points.diffuse, at);
  if constexpr (recording) {
    note_texture(color, chunk.used, *points.notes, at);
  }
}

// The footprints on the surfaces, for textures and for secondary rays.
inline void footprint_chunk(const ChunkShapes& shapes, const WaveRays& rays, bool textured,
                            WavePoints& points, int at) {
  const std::uint32_t* const ray = points.ray + at;
  const V3 geometric = load3(points.geometric, at);
  const Steps steps =
      arriving_steps(gather_steps(rays.origin_steps, ray), gather_steps(rays.direction_steps, ray),
                     load3(points.direction, at), geometric, load(points.t + at));
  if (textured) {
    filtered_texture_chunk(shapes, steps, rays, points, at);
  }
  const bool goes_on = std::any_of(points.material + at, points.material + at + lanes,
                                   [](const WaveMaterial* m) { return m->mirrors || m->refracts; });
  if (goes_on) {
    const auto turn = [&](const V3& step) {
      return world_normal_turn(shapes.map.x, shapes.map.y, shapes.map.z, shapes.shape, shapes.face,
                               shapes.point, shapes.normal, step);
    };
    store_steps(steps, points.steps, at);
    store_steps({turn(steps.x), turn(steps.y)}, points.turns, at);
  }
}

inline void texture_chunk(const WaveScene& scene, F shape, F face, const V3& p, WavePoints& points,
                          int at) {
  const ChunkTextures chunk = chunk_textures(points, at);
  F u;
  F v;
  object_uv(shape, face, p, chunk.used, u, v);
  const V3 plain = load3(points.diffuse, at);
  const V3 color = texture_at(scene, chunk, u, v);
  store3(select(chunk.used, mix(plain, color, chunk.blend), plain), points.diffuse, at);
  if constexpr (recording) {
    note_texture(color, chunk.used, *points.notes, at);
  }
}

// Sets the materials of a chunk; returns whether any has a texture.
inline bool shape_materials(const WaveScene& scene, const Part* const (&parts)[lanes],
                            WavePoints& points, int at) {
  const WaveMaterial& first = scene.materials[parts[0]->material];
  if (all_one(parts)) {
    std::fill_n(points.material + at, lanes, &first);
    store3(splat_row(first.diffuse), points.diffuse, at);
    store3(splat_row(first.specular), points.specular, at);
    store3(splat_row(first.ambient), points.color, at);
    store(splat(first.shininess), points.shininess + at);
    return first.texture != nullptr || first.pyramid != nullptr;
  }
  bool textured = false;
  for (int i = 0; i < lanes; ++i) {
    const WaveMaterial& material = scene.materials[parts[i]->material];
    put_material(material, color_of(material.diffuse), points, at + i);
    textured = textured || material.texture != nullptr || material.pyramid != nullptr;
  }
  return textured;
}

// For chunks that only have shapes of the root group.
inline void shape_surfaces(const WaveScene& scene, const WaveRays& rays, const WaveHits& hits,
                           bool lit, WavePoints& points, int at) {
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
  const V3 normal_there = object_normal(chunk.shape, load(faces), object_point);
  const V3 normal = world_normal(chunk.map, normal_there);
  store3(position, points.position, at);
  store3(normal, points.normal, at);
  store3(normal, points.geometric, at);
  const bool filtered = !scene.course && scene.tracer.options.features.texture_filter;
  const ChunkShapes shapes{chunk.map, chunk.shape, load(faces), object_point, normal_there};
  if (points.with_uv) {
    store_uv(shapes, points, at);
  }
  if constexpr (recording) {
    note_shapes(shapes, *points.notes, at);
  }
  if (scene.by_footprint) {
    footprint_chunk(shapes, rays, textured && filtered, points, at);
  }
  if (textured && !filtered) {
    texture_chunk(scene, chunk.shape, load(faces), object_point, points, at);
  }
}

/// Computes everything except lighting at the points. `lit`: with bump maps and textures.
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
      shape_surfaces(scene, rays, hits, lit, points, at);
    }
    for (int i = at; i < at + lanes; ++i) {
      if (!shapes || (lit && points.material[i]->bumped)) {
        surface_of_one(scene, rays, hits, lit, points, i);
      }
    }
    const V3 position = load3(points.position, at);
    store(scene.course ? splat(course_offset) : fine_offset(position, load(points.t + at)),
          points.offset + at);
  }
}

}  // namespace scenefile::SCENEFILE_LANES
