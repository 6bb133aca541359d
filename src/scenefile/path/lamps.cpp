#include "scenefile/path/lamps.h"

#include "scenefile/geometry/ray_box.h"
#include "scenefile/trace/surface_point.h"
#include "scenefile/trace/texture_lookup.h"
#include "scenefile/trace/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace scenefile {

namespace {

// More lamps than this take too much memory.
constexpr std::size_t most_lamps = 1u << 22;

// The mean of a texture's colors; white if it cannot be used.
Color mean_of(const Assets& assets, std::uint32_t map) {
  if (map == no_map || assets.textures[map].empty()) {
    return Color(1);
  }
  const std::vector<std::uint8_t>& rgb = assets.textures[map].rgb;
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    sum += glm::dvec3(rgb[i], rgb[i + 1], rgb[i + 2]);
  }
  return sum / (255.0 * static_cast<double>(rgb.size() / 3));
}

std::vector<std::vector<double>> mean_radiance(const Assets& assets) {
  std::vector<std::vector<double>> radiance;
  for (const MeshMaterials& mesh : assets.mesh_materials) {
    std::vector<double>& of_mesh = radiance.emplace_back();
    for (const FaceMaterial& m : mesh.materials) {
      const Color emission(m.emission);
      of_mesh.push_back(
          emission == Color(0) ? 0 : luminance(emission * mean_of(assets, m.emission_map)));
    }
  }
  return radiance;
}

// Whether two places are the same is all that counts.
bool ordered(const DAffine& a, const DAffine& b) {
  return std::memcmp(&a, &b, sizeof(DAffine)) < 0;  // NOLINT(bugprone-suspicious-memory-comparison)
}

// Maps the unit square to barycentric weights, uniformly (Heitz, "A Low-Distortion Map Between
// Triangle and Square", 2019).
glm::dvec2 in_triangle(const glm::dvec2& p) {
  return p.y > p.x ? glm::dvec2(p.x / 2, p.y - p.x / 2) : glm::dvec2(p.x - p.y / 2, p.y / 2);
}

}  // namespace

Color map_color(const Assets& assets, std::uint32_t map, const glm::dvec2& uv) {
  return map == no_map || assets.textures[map].empty()
             ? Color(1)
             : lookup_smooth(assets.textures[map], RenderTexture{map}, uv);
}

AliasTable::AliasTable(const std::vector<double>& weights) : entries_(weights.size()) {
  double sum = 0;
  for (const double w : weights) {
    sum += w;
  }
  // Relative to the mean; entries below it are filled up by those above it.
  std::vector<double> rest(weights.size());
  std::vector<std::uint32_t> small;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    rest[i] = weights[i] / sum * static_cast<double>(weights.size());
    (rest[i] < 1 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t low = small.back();
    const std::uint32_t high = large.back();
    small.pop_back();
    entries_[low] = {rest[low], high};
    rest[high] -= 1 - rest[low];
    if (rest[high] < 1) {
      large.pop_back();
      small.push_back(high);
    }
  }
}

std::uint32_t AliasTable::choose(double& u) const {
  const double place = u * static_cast<double>(entries_.size());
  const auto index =
      std::min(static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(entries_.size() - 1));
  const auto& [keep, other] = entries_[index];
  const double rest = place - index;
  constexpr double below_one = 1 - 0x1p-53;
  u = std::min(rest < keep ? rest / keep : (rest - keep) / (1 - keep), below_one);
  return rest < keep ? index : other;
}

Lamps::Lamps(const SceneGeometry& geometry, const Assets& assets)
    : assets_(&assets), radiance_(mean_radiance(assets)) {
  if (!geometry.groups.empty()) {
    find_places(geometry);
    add_triangles(geometry);
  }
}

void Lamps::find_places(const SceneGeometry& geometry) {
  const auto shines = [&](std::uint32_t mesh) {
    return mesh < radiance_.size() && std::any_of(radiance_[mesh].begin(), radiance_[mesh].end(),
                                                  [](double radiance) { return radiance > 0; });
  };
  // Groups come after those that they contain.
  std::vector<bool> group_shines(geometry.groups.size());
  const auto object_shines = [&](const Object& object) {
    return (object.kind == ObjectKind::mesh && shines(object.target)) ||
           (object.kind == ObjectKind::instance && group_shines[object.target]);
  };
  for (std::size_t g = 0; g < geometry.groups.size(); ++g) {
    const std::vector<Object>& list = geometry.groups[g].objects;
    group_shines[g] = std::any_of(list.begin(), list.end(), object_shines);
  }
  struct Entered {
    std::uint32_t group = 0;
    DAffine group_from_world;
  };
  std::vector<Entered> open{{geometry.root, {}}};
  while (!open.empty() && places_.size() + open.size() <= most_lamps) {
    const Entered entered = open.back();
    open.pop_back();
    for (const Object& object : geometry.groups[entered.group].objects) {
      if (!object_shines(object)) {
        continue;
      }
      const DAffine object_from_world =
          DAffine(object.object_from_group) * entered.group_from_world;
      if (object.kind == ObjectKind::instance) {
        open.push_back({object.target, object_from_world});
      } else {
        places_.push_back(
            {inverse(object_from_world), object_from_world, object.target, object.source});
      }
    }
  }
  if (!open.empty()) {
    places_.clear();
  }
  // A mesh that is twice at the same place is one lamp, also for size(), which Convention::course
  // divides by. seen() and reveal() know what else coincides.
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return a.mesh != b.mesh ? a.mesh < b.mesh : ordered(a.object_from_world, b.object_from_world);
  });
  places_.erase(std::unique(places_.begin(), places_.end(),
                            [](const Place& a, const Place& b) {
                              return a.mesh == b.mesh && a.object_from_world == b.object_from_world;
                            }),
                places_.end());
}

void Lamps::add_triangles(const SceneGeometry& geometry) {
  std::vector<double> powers;
  std::vector<Bounds> bounds;
  Bounds whole;
  for (std::uint32_t p = 0; p < places_.size(); ++p) {
    const Place& place = places_[p];
    const Mesh& mesh = assets_->meshes[place.mesh];
    const std::vector<std::uint32_t>& materials = assets_->mesh_materials[place.mesh].of_triangle;
    const std::vector<std::uint32_t>& hit = geometry.meshes[place.mesh].triangles;
    const std::size_t count = hit.empty() ? mesh.triangles.size() : hit.size();
    for (std::size_t i = 0; i < count && triangles_.size() <= most_lamps; ++i) {
      const std::uint32_t index = hit.empty() ? static_cast<std::uint32_t>(i) : hit[i];
      const std::uint32_t material = materials.empty() ? mesh_no_index : materials[index];
      if (material == mesh_no_index || radiance_[place.mesh][material] <= 0) {
        continue;
      }
      const auto& corners = mesh.triangles[index];
      const auto edge = [&](int corner) {
        return place.world_from_object.vector(glm::dvec3(mesh.positions[corners[corner]]) -
                                              glm::dvec3(mesh.positions[corners[0]]));
      };
      const double area = glm::length(glm::cross(edge(1), edge(2))) / 2;
      const double power = area * radiance_[place.mesh][material];
      if (power > 0 && std::isfinite(power)) {
        triangles_.push_back({p, index});
        areas_.push_back(area);
        powers.push_back(power);
        Bounds box;
        for (const std::uint32_t corner : corners) {
          box = unite(box, place.world_from_object.point(glm::dvec3(mesh.positions[corner])));
        }
        bounds.push_back(box);
        whole = unite(whole, box);
        power_ += power;
      }
    }
  }
  if (triangles_.size() > most_lamps || !std::isfinite(power_)) {
    triangles_.clear();
  }
  if (!triangles_.empty()) {
    table_ = AliasTable(powers);
    extent_ = extent_of(whole);
    const double scale = extent_.scale;
    std::vector<FloatBox> boxes;
    for (const Bounds& box : bounds) {
      boxes.push_back(padded(scaled(box, scale), scaled(whole, scale)));
    }
    boxes_.emplace(boxes);
    overlap_ = find_overlap();
  }
}

bool Lamps::find_overlap() const {
  const Bounds& box = extent_.bounds;
  const double far = extent_.diagonal + glm::length(glm::max(glm::abs(box.min), glm::abs(box.max)));
  bool found = false;
  for (std::uint32_t i = 0; i < triangles_.size() && !found; ++i) {
    // The center, and three points near the corners.
    for (const glm::dvec2& weights :
         {glm::dvec2(1 / 3.0), glm::dvec2(0.01), glm::dvec2(0.98, 0.01), glm::dvec2(0.01, 0.98)}) {
      const LampPoint point = point_on(i, weights);
      visit_at({point.position + far * point.normal, -point.normal}, far, i,
               [&](std::uint32_t, const glm::dvec2&) { found = true; });
    }
  }
  return found;
}

LampPoint Lamps::sample(glm::dvec2 point) const {
  const std::uint32_t chosen = table_.choose(point.x);
  return point_on(chosen, parallelograms_ ? point : in_triangle(point));
}

Color Lamps::emission(std::size_t triangle) const {
  return point_on(static_cast<std::uint32_t>(triangle), glm::dvec2(1 / 3.0)).emission;
}

LampPoint Lamps::point_on(std::uint32_t chosen, const glm::dvec2& weights) const {
  const Triangle& triangle = triangles_[chosen];
  const Place& place = places_[triangle.place];
  const Mesh& mesh = assets_->meshes[place.mesh];
  const Surface surface = surface_at(mesh, triangle.index, weights.x, weights.y, false);
  const auto& corners = mesh.triangles[triangle.index];
  const auto corner = [&](int i) { return glm::dvec3(mesh.positions[corners[i]]); };
  const std::uint32_t index = assets_->mesh_materials[place.mesh].of_triangle[triangle.index];
  const FaceMaterial& material = assets_->mesh_materials[place.mesh].materials[index];
  LampPoint lamp;
  lamp.position = place.world_from_object.point(corner(0) + weights.x * (corner(1) - corner(0)) +
                                                weights.y * (corner(2) - corner(0)));
  lamp.normal = world_normal(place.object_from_world, surface.normal);
  lamp.emission = Color(material.emission) * map_color(*assets_, material.emission_map, surface.uv);
  lamp.density = density(place.mesh, index);
  lamp.triangle = chosen;
  lamp.weights = weights;
  return lamp;
}

template <typename Visit>
void Lamps::visit_at(const Ray& ray, double t, std::uint32_t known, const Visit& visit) const {
  if (!boxes_ || !holds(extent_.bounds, ray.origin + t * ray.direction)) {
    return;
  }
  const double rounding = 1e-9 * t;
  const auto end = [&] { return t + rounding; };
  const Ray search{extent_.scale * ray.origin, extent_.scale * ray.direction};
  boxes_->search(search, t - rounding, end, [&](std::uint32_t index) {
    if (index == known) {
      return;
    }
    const Place& place = places_[triangles_[index].place];
    const Ray in_object{place.object_from_world.point(ray.origin),
                        place.object_from_world.vector(ray.direction)};
    TriangleHit hit;
    double facing = 0;
    if (meet_plane(assets_->meshes[place.mesh], triangles_[index].index, in_object, hit, facing) &&
        facing < 0 && std::abs(hit.t - t) <= rounding && hit.b1 >= 0 && hit.b2 >= 0 &&
        hit.b1 + hit.b2 <= 1) {
      visit(index, glm::dvec2(hit.b1, hit.b2));
    }
  });
}

LampPoint Lamps::seen(const Ray& ray, double distance, const LampPoint& lamp) const {
  if (parallelograms_ || !overlap_) {
    return lamp;
  }
  std::uint32_t last = lamp.triangle;
  glm::dvec2 there = lamp.weights;
  double together = lamp.density;
  visit_at(ray, distance, lamp.triangle, [&](std::uint32_t index, const glm::dvec2& weights) {
    together += density(triangles_[index]);
    if (index > last) {
      last = index;
      there = weights;
    }
  });
  LampPoint result = last == lamp.triangle ? lamp : point_on(last, there);
  result.density = together;
  return result;
}

double Lamps::reveal(const Ray& ray, Hit& hit) const {
  std::uint32_t last = 0;
  glm::dvec2 there(0);
  double together = 0;
  visit_at(ray, hit.t, no_index, [&](std::uint32_t index, const glm::dvec2& weights) {
    if (together == 0 || index > last) {
      last = index;
      there = weights;
    }
    together += density(triangles_[index]);
  });
  if (together > 0) {
    const Triangle& triangle = triangles_[last];
    const Place& place = places_[triangle.place];
    if (triangle.index != hit.triangle || place.mesh != hit.mesh ||
        !(place.object_from_world == hit.object_from_world)) {
      hit.shape = Shape::mesh;
      hit.mesh = place.mesh;
      hit.triangle = triangle.index;
      hit.b1 = there.x;
      hit.b2 = there.y;
      hit.source = place.source;
      hit.object_from_world = place.object_from_world;
    }
  }
  return together;
}

double Lamps::density(std::uint32_t mesh, std::uint32_t material) const {
  return empty() ? 0 : radiance_[mesh][material] / power_;
}

double Lamps::density(const Triangle& triangle) const {
  const std::uint32_t mesh = places_[triangle.place].mesh;
  return density(mesh, assets_->mesh_materials[mesh].of_triangle[triangle.index]);
}

}  // namespace scenefile
