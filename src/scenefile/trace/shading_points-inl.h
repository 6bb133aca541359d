// The surfaces at the points hit by the rays of a wavefront. No include guard: included once for
// each instruction set, after intersect-inl.h.

#include "scenefile/trace/wavefront_memory.h"

namespace scenefile::SCENEFILE_LANES {

inline V3 world_normal(const Map& object_from_world, const V3& normal) {
  const V3 n{dot(object_from_world.x, normal), dot(object_from_world.y, normal),
             dot(object_from_world.z, normal)};
  const F size = length(n);
  const M fine = (size > splat(0)) & finite(size);
  return select(fine, n / size, V3{splat(0), splat(1), splat(0)});
}

// Copies data of rays and hits to the points, and pads the last chunk with copies of the last
// point.
inline void gather_rays(const RayQueue& rays, const HitQueue& hits, ShadingPoints& points) {
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

// The vectors of a chunk of rays.
inline V3 gather3(const VectorArrays& from, const std::uint32_t* ray) {
  alignas(64) double rows[3][lanes];
  for (int i = 0; i < lanes; ++i) {
    rows[0][i] = from.x[ray[i]];
    rows[1][i] = from.y[ray[i]];
    rows[2][i] = from.z[ray[i]];
  }
  return {load(rows[0]), load(rows[1]), load(rows[2])};
}

inline Derivatives gather_derivatives(const DerivativeArrays& from, const std::uint32_t* ray) {
  return {gather3(from.dx, ray), gather3(from.dy, ray)};
}

// The complete Hit of ray r of a wavefront.
inline Hit hit_of(const WavefrontScene& scene, const HitQueue& hits, std::uint32_t r,
                  const Ray& ray) {
  if (hits.object[r] < 0) {
    return hits.others[r];
  }
  const Object& object = scene.root[static_cast<std::size_t>(hits.object[r])];
  Hit hit;
  hit.t = hits.t[r];
  hit.shape = object.shape;
  hit.face = static_cast<Face>(hits.face[r]);
  hit.material = object.material;
  hit.source = object.source;
  hit.object = &object;
  hit.object_from_world = DAffine(object.object_from_group);
  hit.object_point = hit.object_from_world.point(ray.origin + hit.t * ray.direction);
  return hit;
}

// The textures of a chunk: one for each lane, with its repeats.
struct ChunkTextures {
  const Texture* texture[lanes] = {};
  M used = no_lanes();
  F width, height, repeat_u, repeat_v;
};

inline ChunkTextures chunk_textures(const ShadingPoints& points, int at) {
  ChunkTextures chunk;
  alignas(64) double numbers[4][lanes] = {};
  unsigned used = 0;
  for (int i = 0; i < lanes; ++i) {
    const ShadingMaterial& material = *points.material[at + i];
    if (material.texture == nullptr) {
      continue;
    }
    used |= 1u << i;
    chunk.texture[i] = material.texture;
    numbers[0][i] = material.texture->width;
    numbers[1][i] = material.texture->height;
    numbers[2][i] = material.material->texture.repeat_u;
    numbers[3][i] = material.material->texture.repeat_v;
  }
  chunk.used = of_bits(used);
  chunk.width = load(numbers[0]);
  chunk.height = load(numbers[1]);
  chunk.repeat_u = load(numbers[2]);
  chunk.repeat_v = load(numbers[3]);
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

inline V3 texture_at(const WavefrontScene& scene, const ChunkTextures& chunk, F u, F v) {
  const F x = texel_x(u, chunk.repeat_u, chunk.width);
  const F y = texel_y(v, chunk.repeat_v, chunk.height);
  const auto at = [&](F column, F row) { return texels(chunk.texture, chunk.width, column, row); };
  if (!scene.tracer.options.features.texture_filter) {
    return at(wrapped(floor(x), chunk.width), wrapped(floor(y), chunk.height));
  }
  return bilinear(chunk.width, chunk.height, x, y, at);
}

// The textures of a chunk that are filtered over footprints, with the interface for filtered().
struct ChunkMipMaps {
  const MipMap* mip_map[lanes] = {};
  M used = no_lanes();
  F count, width, height, repeat_u, repeat_v;

  F levels() const { return count; }

  V3 at(F u, F v, const UvDerivative& right, const UvDerivative& down, F grid, M wanted) const {
    return filtered(*this, texel_x(u, repeat_u, width), texel_y(v, repeat_v, height),
                    texel_footprint(right, down, repeat_u, repeat_v, width, height), grid, wanted);
  }

  V3 smooth(F level, M wanted, F x, F y) const {
    const Texture* texture[lanes] = {};
    alignas(64) double numbers[3][lanes];
    store(level, numbers[0]);
    const unsigned lanes_wanted = bits(wanted);
    for (int i = 0; i < lanes; ++i) {
      numbers[1][i] = numbers[2][i] = 1;
      if ((lanes_wanted >> i & 1) != 0) {
        texture[i] = &mip_map[i]->level(static_cast<int>(numbers[0][i]));
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

inline ChunkMipMaps chunk_mip_maps(const ShadingPoints& points, int at,
                                   const MipMap* ShadingMaterial::*map,
                                   RenderTexture RenderMaterial::*use) {
  ChunkMipMaps chunk;
  alignas(64) double numbers[5][lanes];
  unsigned used = 0;
  for (int i = 0; i < lanes; ++i) {
    const ShadingMaterial& material = *points.material[at + i];
    const MipMap* const mip_map = material.*map;
    const bool has = mip_map != nullptr && !mip_map->empty();
    used |= has ? 1u << i : 0u;
    chunk.mip_map[i] = mip_map;
    numbers[0][i] = has ? mip_map->levels() : 1;
    numbers[1][i] = has ? mip_map->level(0).width : 1;
    numbers[2][i] = has ? mip_map->level(0).height : 1;
    numbers[3][i] = has ? (material.material->*use).repeat_u : 1;
    numbers[4][i] = has ? (material.material->*use).repeat_v : 1;
  }
  chunk.used = of_bits(used);
  chunk.count = load(numbers[0]);
  chunk.width = load(numbers[1]);
  chunk.height = load(numbers[2]);
  chunk.repeat_u = load(numbers[3]);
  chunk.repeat_v = load(numbers[4]);
  return chunk;
}

// What a chunk of points is on.
struct ChunkHits {
  Map map;  // from world to object space
  F shape;
  F face;
  M mesh = no_lanes();
  M has_uv = !no_lanes();
  MeshPoint on_mesh[lanes];  // in the lanes of `mesh`
};

// Sets the materials of a chunk.
inline void set_materials(const WavefrontScene& scene, const std::uint32_t (&materials)[lanes],
                          ShadingPoints& points, int at) {
  const ShadingMaterial& first = scene.materials[materials[0]];
  if (std::all_of(materials, materials + lanes,
                  [&](std::uint32_t material) { return material == materials[0]; })) {
    std::fill_n(points.material + at, lanes, &first);
    store3(splat_row(first.diffuse), points.diffuse, at);
    store3(splat_row(first.specular), points.specular, at);
    store3(splat_row(first.ambient), points.color, at);
    store(splat(first.shininess), points.shininess + at);
    return;
  }
  for (int i = 0; i < lanes; ++i) {
    const ShadingMaterial& material = scene.materials[materials[i]];
    points.material[at + i] = &material;
    put(color_of(material.diffuse), points.diffuse, at + i);
    put(color_of(material.specular), points.specular, at + i);
    put(color_of(material.ambient), points.color, at + i);
    points.shininess[at + i] = material.shininess;
  }
}

// Also sets the materials of the points.
inline ChunkHits chunk_hits(const WavefrontScene& scene, const HitQueue& hits,
                            ShadingPoints& points, int at) {
  const std::uint32_t* const ray = points.ray + at;
  ChunkHits chunk;
  std::uint32_t materials[lanes];
  alignas(64) double faces[lanes];
  const double first = hits.object[ray[0]];
  if (first >= 0 &&
      std::all_of(ray, ray + lanes, [&](std::uint32_t r) { return hits.object[r] == first; })) {
    const Object& object = scene.root[static_cast<std::size_t>(first)];
    for (int i = 0; i < lanes; ++i) {
      faces[i] = hits.face[ray[i]];
    }
    std::fill_n(materials, lanes, object.material);
    set_materials(scene, materials, points, at);
    chunk.map = splat_map(object.object_from_group);
    chunk.shape = splat(static_cast<int>(object.shape));
    chunk.face = load(faces);
    return chunk;
  }
  alignas(64) double m[12][lanes];
  alignas(64) double shapes[lanes];
  unsigned meshes = 0;
  unsigned without_uv = 0;
  const auto put_map = [&](const auto& map, int i) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        m[3 * column + row][i] = map.linear[column][row];
      }
      m[9 + row][i] = map.offset[row];
    }
  };
  for (int i = 0; i < lanes; ++i) {
    if (hits.object[ray[i]] >= 0) {
      const Object& object = scene.root[static_cast<std::size_t>(hits.object[ray[i]])];
      put_map(object.object_from_group, i);
      materials[i] = object.material;
      shapes[i] = static_cast<int>(object.shape);
      faces[i] = hits.face[ray[i]];
      continue;
    }
    const Hit& hit = hits.others[ray[i]];
    put_map(hit.object_from_world, i);
    materials[i] = hit.material;
    shapes[i] = static_cast<int>(hit.shape);
    faces[i] = static_cast<int>(hit.face);
    if (hit.shape == Shape::mesh) {
      const Mesh& mesh = scene.tracer.assets.meshes[hit.mesh];
      chunk.on_mesh[i] = {&mesh, hit.triangle, hit.b1, hit.b2};
      meshes |= 1u << i;
      without_uv |= unsigned(mesh.triangle_uvs.empty()) << i;
    }
  }
  set_materials(scene, materials, points, at);
  const auto vector = [&](int row) { return V3{load(m[row]), load(m[row + 1]), load(m[row + 2])}; };
  chunk.map = {vector(0), vector(3), vector(6), vector(9)};
  chunk.shape = load(shapes);
  chunk.face = load(faces);
  chunk.mesh = of_bits(meshes);
  chunk.has_uv = !of_bits(without_uv);
  return chunk;
}

// The surface of a chunk of points, in object space.
struct ChunkSurface {
  ChunkHits hits;
  V3 point;
  SurfaceLanes local;
  V3 flat;  // the geometric normal

  UvDerivative uv_derivative(const V3& world_step) const {
    const V3 step = hits.map.vector(world_step);
    UvDerivative of_shape{splat(0), splat(0)};
    if (!every(hits.mesh)) {
      of_shape = shape_uv_derivative(hits.shape, hits.face, point, step);
    }
    if (none(hits.mesh)) {
      return of_shape;
    }
    const UvDerivative of_mesh = mesh_uv_derivative(local.tangent_u, local.tangent_v, step);
    const auto chosen = [&](F mesh, F shape) {
      return select(hits.has_uv, select(hits.mesh, mesh, shape), splat(0));
    };
    return {chosen(of_mesh.u, of_shape.u), chosen(of_mesh.v, of_shape.v)};
  }

  V3 normal_derivative(const V3& step) const {
    const Map& map = hits.map;
    return world_normal_derivative(map.x, map.y, map.z, hits.shape, hits.face, point, local.normal,
                                   step);
  }
};

// Which data of the surfaces the materials of a chunk need.
struct ChunkNeeds {
  bool texture = false;
  bool mip_map = false;
  bool bump = false;
  bool next = false;  // rays that go on

  bool uv() const { return texture || mip_map || bump; }
};

inline ChunkNeeds chunk_needs(const ShadingPoints& points, int at, bool lit) {
  ChunkNeeds needs;
  for (int i = at; i < at + lanes; ++i) {
    const ShadingMaterial& m = *points.material[i];
    needs.texture = needs.texture || (lit && m.texture != nullptr);
    needs.mip_map = needs.mip_map || (lit && m.mip_map != nullptr);
    needs.bump = needs.bump || (lit && m.bump != nullptr);
    needs.next = needs.next || m.mirrors || m.refracts;
  }
  return needs;
}

inline ChunkSurface chunk_surface(const ChunkHits& hits, const V3& position, bool smooth, bool uv,
                                  bool tangents) {
  ChunkSurface s{hits, hits.map.point(position), {}, {}};
  if (!every(hits.mesh)) {
    s.local.normal = shape_normal(hits.shape, hits.face, s.point);
    if (uv) {
      set_shape_uv(hits.shape, hits.face, s.point, s.local);
    }
    if (tangents) {
      set_shape_tangents(hits.shape, hits.face, s.point, s.local);
    }
  }
  s.flat = s.local.normal;
  if (any(hits.mesh)) {
    const MeshSurface on_mesh = mesh_surface(hits.on_mesh, smooth);
    s.flat = select(hits.mesh, on_mesh.flat, s.flat);
    s.local = select(hits.mesh, on_mesh.surface, s.local);
  }
  return s;
}

// Keeps what only explain.h needs.
inline void record_object_surface(const ChunkSurface& surface, RecordedPoints& recorded, int at) {
  store3(surface.local.normal, recorded.object_normal, at);
  std::fill_n(recorded.has_uv + at, lanes, any(surface.hits.has_uv));
  std::fill_n(recorded.bumped + at, lanes, false);
  std::fill_n(recorded.textured + at, lanes, false);
}

inline void blend_texture(const V3& color, M used, ShadingPoints& points, int at) {
  alignas(64) double blend[lanes];
  for (int i = 0; i < lanes; ++i) {
    blend[i] = points.material[at + i]->blend;
  }
  const V3 plain = load3(points.diffuse, at);
  store3(select(used, mix(plain, color, load(blend)), plain), points.diffuse, at);
  if constexpr (recording) {
    store3(color, points.recorded->texture, at);
    std::fill_n(points.recorded->textured + at, lanes, any(used));
  }
}

// Replaces the shading normals by those of bump maps.
inline void bump_chunk(const ChunkSurface& surface, const UvDerivative& right,
                       const UvDerivative& down, F grid, ShadingPoints& points, int at) {
  const ChunkMipMaps chunk =
      chunk_mip_maps(points, at, &ShadingMaterial::bump, &RenderMaterial::bump_map);
  const UvDerivative across{right.u / grid, right.v / grid};
  const UvDerivative along{down.u / grid, down.v / grid};
  M wanted = chunk.used & surface.hits.has_uv;
  const V3 bumped = bumped_normal(
      surface.local, across, along, chunk.repeat_u * chunk.width, chunk.repeat_v * chunk.height,
      wanted, [&](F u, F v, M where) { return chunk.at(u, v, across, along, splat(1), where); });
  const V3 plain = load3(points.normal, at);
  const V3 normal = select(wanted, world_normal(surface.hits.map, bumped), plain);
  store3(normal, points.normal, at);
  if constexpr (recording) {
    const M same = (normal.x == plain.x) & (normal.y == plain.y) & (normal.z == plain.z);
    std::fill_n(points.recorded->bumped + at, lanes, !every(same));
  }
}

// What is filtered over footprints, and the footprints on the surfaces for secondary rays.
inline void footprint_chunk(const ChunkSurface& surface, const RayQueue& rays,
                            const ChunkNeeds& needs, ShadingPoints& points, int at) {
  const std::uint32_t* const ray = points.ray + at;
  const Derivatives dp = hit_derivatives(
      gather_derivatives(rays.d_origin, ray), gather_derivatives(rays.d_direction, ray),
      load3(points.direction, at), load3(points.geometric, at), load(points.t + at));
  if (needs.bump || needs.mip_map) {
    const UvDerivative right = surface.uv_derivative(dp.dx);
    const UvDerivative down = surface.uv_derivative(dp.dy);
    alignas(64) double grids[lanes];
    for (int i = 0; i < lanes; ++i) {
      grids[i] = rays.key[ray[i]].texture_grid;
    }
    if (needs.bump) {
      bump_chunk(surface, right, down, load(grids), points, at);
    }
    if (needs.mip_map) {
      const ChunkMipMaps chunk =
          chunk_mip_maps(points, at, &ShadingMaterial::mip_map, &RenderMaterial::texture);
      blend_texture(
          chunk.at(surface.local.u, surface.local.v, right, down, load(grids), chunk.used),
          chunk.used, points, at);
    }
  }
  if (needs.next) {
    store_derivatives(dp, points.dp, at);
    store_derivatives({surface.normal_derivative(dp.dx), surface.normal_derivative(dp.dy)},
                      points.dn, at);
  }
}

/// Computes everything except lighting at the points. `lit`: with bump maps and textures.
inline void find_surfaces(const WavefrontScene& scene, const RayQueue& rays, const HitQueue& hits,
                          bool lit, ShadingPoints& points) {
  if (points.count == 0) {
    return;
  }
  gather_rays(rays, hits, points);
  for (int at = 0; at < points.count; at += lanes) {
    const ChunkHits on = chunk_hits(scene, hits, points, at);
    const ChunkNeeds needs = chunk_needs(points, at, lit);
    const V3 position =
        load3(points.normal, at) + load(points.t + at) * load3(points.direction, at);
    const ChunkSurface surface =
        chunk_surface(on, position, !scene.course, points.with_uv || needs.uv(), needs.bump);
    const V3 normal = world_normal(on.map, surface.local.normal);
    store3(position, points.position, at);
    store3(normal, points.normal, at);
    store3(any(on.mesh) ? world_normal(on.map, surface.flat) : normal, points.geometric, at);
    store(scene.course ? splat(course_offset) : fine_offset(position, load(points.t + at)),
          points.offset + at);
    if (points.with_uv) {
      store(surface.local.u, points.u + at);
      store(surface.local.v, points.v + at);
    }
    if constexpr (recording) {
      record_object_surface(surface, *points.recorded, at);
    }
    if (scene.by_footprint) {
      footprint_chunk(surface, rays, needs, points, at);
    }
    if (needs.texture) {
      const ChunkTextures chunk = chunk_textures(points, at);
      blend_texture(texture_at(scene, chunk, surface.local.u, surface.local.v), chunk.used, points,
                    at);
    }
  }
}

}  // namespace scenefile::SCENEFILE_LANES
