#include "scenefile/scene/prepare_parts.h"
#include "scenefile/scene/template_graph.h"

#include <algorithm>
#include <cmath>

namespace scenefile {

namespace {

constexpr double pi = 3.14159265358979323846;

bool finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::optional<glm::dvec3> unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  if (!(length > 0) || !std::isfinite(length)) {
    return std::nullopt;
  }
  return v / length;
}

// All zero would divide by zero, where the formula's limit is no falloff at all.
glm::vec3 safe_attenuation(const glm::vec3& written) {
  const glm::vec3 coefficients = glm::max(written, glm::vec3(0));
  return coefficients == glm::vec3(0) ? glm::vec3(1, 0, 0) : coefficients;
}

void set_cone(RenderLight& ready, const Light& light) {
  const double penumbra = std::max(0.0, static_cast<double>(light.penumbra_deg));
  const double outer = std::clamp<double>(light.angle_deg.value_or(light.penumbra_deg), 0, 180);
  ready.outer_angle = static_cast<float>(outer * pi / 180);
  ready.inner_angle = static_cast<float>(std::max(0.0, outer - penumbra) * pi / 180);
}

// The format leaves the orientation of the rectangle about its direction open: `width` lies level,
// `height` upright, as a picture hangs on a wall.
void set_rectangle(RenderLight& ready, const Light& light, const glm::dvec3& direction,
                   const DAffine& space_from_node) {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 side = glm::cross(direction, up);
  const glm::dvec3 u = glm::length(side) > 1e-6 ? glm::normalize(side) : glm::dvec3(1, 0, 0);
  const glm::dvec3 v = glm::normalize(glm::cross(u, direction));
  const glm::dvec3 half_u = space_from_node.vector(u * (std::max(0.0f, light.width) / 2.0));
  const glm::dvec3 half_v = space_from_node.vector(v * (std::max(0.0f, light.height) / 2.0));
  ready.half_u = glm::vec3(half_u);
  ready.half_v = glm::vec3(half_v);
  // Under a shear the normal of the rectangle is not where its old normal goes.
  if (const std::optional<glm::dvec3> normal = unit(glm::cross(half_u, half_v))) {
    const bool front = glm::dot(*normal, glm::dvec3(ready.direction)) >= 0;
    ready.direction = glm::vec3(front ? *normal : -*normal);
  }
}

// Walks the instances that lead to lights, and no others: the steps are bounded by the number of
// lights times the nesting, not by the number of copies.
class LightWalk {
 public:
  LightWalk(const std::vector<Part>& parts, std::uint32_t max_lights)
      : parts_(parts), max_lights_(max_lights) {
    Graph graph;
    std::vector<double> own;
    for (const Part& part : parts) {
      graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
      for (const PartInstance& instance : part.instances) {
        graph.target.push_back(instance.part);
      }
      own.push_back(static_cast<double>(part.lights.size()));
    }
    graph.first.push_back(static_cast<std::uint32_t>(graph.target.size()));
    rank_ = containment_order(graph).rank;
    lights_below_ = totals(graph, std::move(own));
  }

  std::vector<RenderLight> run() {
    enter(0, DAffine());
    while (!frames_.empty() && lights_.size() < max_lights_) {
      Frame& top = frames_.back();
      const Part& part = parts_[top.part];
      if (top.next == part.instances.size()) {
        frames_.pop_back();
        continue;
      }
      const PartInstance& instance = part.instances[top.next++];
      if (lights_below_[instance.part] > 0 && rank_[instance.part] < rank_[top.part]) {
        enter(instance.part, top.world_from_part * DAffine(instance.part_from_instance));
      }
    }
    return std::move(lights_);
  }

 private:
  struct Frame {
    std::uint32_t part;
    std::size_t next;
    DAffine world_from_part;
  };

  void enter(std::uint32_t part, const DAffine& world_from_part) {
    for (const PlacedLight& placed : parts_[part].lights) {
      if (lights_.size() == max_lights_) {
        return;
      }
      std::optional<RenderLight> light =
          ready_light(*placed.light, world_from_part * placed.part_from_node);
      if (light) {
        light->source = placed.source;
        lights_.push_back(*light);
      }
    }
    frames_.push_back({part, 0, world_from_part});
  }

  const std::vector<Part>& parts_;
  std::size_t max_lights_;
  std::vector<std::uint32_t> rank_;
  std::vector<double> lights_below_;
  std::vector<Frame> frames_;
  std::vector<RenderLight> lights_;
};

}  // namespace

std::optional<RenderLight> ready_light(const Light& light, const DAffine& space_from_node) {
  RenderLight ready;
  ready.type = light.type;
  ready.color = light.color;
  if (light.type != LightType::directional) {
    const glm::dvec3 position = space_from_node.point(glm::dvec3(light.position));
    if (!finite(position)) {
      return std::nullopt;
    }
    ready.position = glm::vec3(position);
    ready.attenuation = safe_attenuation(light.attenuation);
  }
  if (light.type == LightType::point) {
    return ready;
  }
  const std::optional<glm::dvec3> local = unit(glm::dvec3(light.direction));
  const std::optional<glm::dvec3> world =
      local ? unit(space_from_node.vector(*local)) : std::nullopt;
  if (!world) {
    return std::nullopt;
  }
  ready.direction = glm::vec3(*world);
  if (light.type == LightType::spot) {
    set_cone(ready, light);
  } else if (light.type == LightType::area) {
    set_rectangle(ready, light, *local, space_from_node);
  }
  return ready;
}

bool alike(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::dvec3(a) - glm::dvec3(b)) <= 1e-5 * glm::length(glm::dvec3(a));
}

bool alike(const RenderLight& a, const RenderLight& b) {
  const auto same_side = [](const glm::vec3& x, const glm::vec3& y) {
    return alike(x, y) || alike(x, -y);
  };
  RenderLight moved = b;
  if (a.type == LightType::area && alike(a.direction, b.direction) &&
      same_side(a.half_u, b.half_u) && same_side(a.half_v, b.half_v)) {
    moved.direction = a.direction;
    moved.half_u = a.half_u;
    moved.half_v = a.half_v;
  }
  return a == moved;
}

std::vector<RenderLight> world_lights(const std::vector<Part>& parts, std::uint32_t max_lights) {
  return LightWalk(parts, max_lights).run();
}

}  // namespace scenefile
