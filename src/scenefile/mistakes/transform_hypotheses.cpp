#include "scenefile/mistakes/hypothesis_list.h"
#include "scenefile/mistakes/node_matrices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenefile {

using std::numbers::pi;

namespace {

// Moves each primitive and light to a separate node below the root, with a matrix computed by these
// mistakes.
bool place_all(Scene& scene, const MatrixMistakes& mistakes) {
  Scene flat;
  flat.name = scene.name;
  flat.global = scene.global;
  flat.camera = scene.camera;
  const bool visited =
      visit_nodes(scene, mistakes, [&](const Node& node, const glm::dmat4& matrix) {
        const auto add = [&](const glm::dmat4& map) -> Node& {
          Node& added = flat.nodes[add_child(flat, flat.root)];
          added.transforms.push_back({Matrix(glm::mat4(map)), {}});
          return added;
        };
        if (!node.primitives.empty()) {
          // Only the upper three rows of the inverse transform rays to object space.
          glm::dmat4 to_world = mistakes.transposed ? glm::transpose(matrix) : matrix;
          if (mistakes.untranslated) {
            to_world[3] = glm::dvec4(0, 0, 0, 1);
          } else if (mistakes.inverse_by_transpose) {
            const glm::dmat3 turned = glm::transpose(glm::dmat3(matrix));
            glm::dmat4 to_object(turned);
            to_object[3] = glm::dvec4(-(turned * glm::dvec3(matrix[3])), 1);
            to_world = glm::inverse(to_object);
          }
          if (!mistakes.inverted) {
            glm::dmat4 to_object = glm::inverse(to_world);
            for (int column = 0; column < 4; ++column) {
              to_object[column][3] = column == 3 ? 1 : 0;
            }
            to_world = glm::inverse(to_object);
          } else {
            to_world = glm::inverse(to_world);
          }
          add(to_world).primitives = node.primitives;
        }
        if (!node.lights.empty()) {
          add(mistakes.lights_stay ? glm::dmat4(1) : matrix).lights = node.lights;
        }
      });
  if (!visited) {
    return false;
  }
  scene = std::move(flat);
  return true;
}

// Draws a modified scene file. It must use the same assets.
void rewrite(HypothesisList& list, const char* what, const std::function<bool(Scene&)>& change) {
  Scene scene = *list.view.written;
  if (!change(scene)) {
    return;
  }
  const std::optional<RenderScene> ready = ready_with_same_files(list.scene, scene);
  if (!ready) {
    return;
  }
  list.add(
      Cause::transforms, what,
      [changed = *ready](Trial& t) {
        t.scene.groups = changed.groups;
        t.scene.root = changed.root;
        t.scene.materials = changed.materials;
        t.scene.lights = changed.lights;
      },
      Stage::shapes);
}

void place_each(HypothesisList& list, const char* what, const MatrixMistakes& mistakes) {
  rewrite(list, what, [&](Scene& scene) { return place_all(scene, mistakes); });
}

// Without the transforms of the nodes for which `where` holds.
void ignore_transforms(HypothesisList& list, const char* what,
                       const std::function<bool(const Scene&, const Node&)>& where) {
  rewrite(list, what, [&](Scene& scene) {
    std::vector<NodeId> nodes;
    for (NodeId i = 0; i < scene.nodes.size(); ++i) {
      if (!scene.nodes[i].transforms.empty() && where(scene, scene.nodes[i])) {
        nodes.push_back(i);
      }
    }
    for (const NodeId i : nodes) {
      scene.nodes[i].transforms.clear();
    }
    return !nodes.empty();
  });
}

void rewrite_each(HypothesisList& list, const char* what,
                  const std::function<bool(Transform&)>& change) {
  rewrite(list, what, [&](Scene& scene) {
    bool any = false;
    for (Node& node : scene.nodes) {
      for (Transform& transform : node.transforms) {
        any = change(transform) || any;
      }
    }
    return any;
  });
}

// Makes a transform of this kind the identity.
template <typename Kind>
bool drop(Transform& t) {
  const bool any = std::holds_alternative<Kind>(t.map);
  if (any) {
    t.map = Translate();
  }
  return any;
}

// Programs that keep one translation, rotation and scaling for each block multiply them in an order
// of their own.
void add_orders(HypothesisList& list) {
  using Map = decltype(Transform::map);
  const auto place = [](std::string_view order, const Map& map) {
    return std::holds_alternative<Translate>(map) ? order.find('T')
           : std::holds_alternative<Rotate>(map)  ? order.find('R')
           : std::holds_alternative<Scale>(map)   ? order.find('S')
                                                  : order.size();
  };
  Scene reversed = *list.view.written;
  for (Node& node : reversed.nodes) {
    std::reverse(node.transforms.begin(), node.transforms.end());
  }
  std::vector<Scene> seen{*list.view.written, std::move(reversed)};
  for (const std::string_view order : {"T R S", "T S R", "S R T", "S T R", "R T S", "R S T"}) {
    rewrite(
        list,
        fmt::format("the transforms of each block are multiplied in the order {}", order).c_str(),
        [&](Scene& scene) {
          for (Node& node : scene.nodes) {
            std::stable_sort(node.transforms.begin(), node.transforms.end(),
                             [&](const Transform& a, const Transform& b) {
                               return place(order, a.map) < place(order, b.map);
                             });
          }
          const bool fresh = std::find(seen.begin(), seen.end(), scene) == seen.end();
          if (fresh) {
            seen.push_back(scene);
          }
          return fresh;
        });
  }
}

}  // namespace

std::optional<RenderScene> ready_with_same_files(const RenderScene& scene, const Scene& changed) {
  const auto number = [](const std::vector<FileReference>& files, const std::string& name) {
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const FileReference& f) { return f.name == name; });
    return found == files.end() ? no_index : static_cast<std::uint32_t>(found - files.begin());
  };
  RenderScene ready = prepare(changed, Limits()).scene;
  for (RenderMaterial& m : ready.materials) {
    for (RenderTexture* texture : {&m.texture, &m.bump_map}) {
      if (texture->used()) {
        texture->file = number(scene.texture_files, ready.texture_files[texture->file].name);
        if (!texture->used()) {
          return std::nullopt;
        }
      }
    }
  }
  for (RenderGroup& group : ready.groups) {
    for (RenderPrimitive& p : group.primitives) {
      if (p.mesh != no_index) {
        p.mesh = number(scene.mesh_files, ready.mesh_files[p.mesh].name);
        if (p.mesh == no_index) {
          return std::nullopt;
        }
      }
    }
  }
  return ready;
}

void add_transforms(HypothesisList& list) {
  static constexpr std::size_t max_nodes = 3000;
  if (list.view.written == nullptr || list.view.written->nodes.size() > max_nodes) {
    return;
  }
  rewrite(list, "transforms are applied in reverse order", [](Scene& scene) {
    bool any = false;
    for (Node& node : scene.nodes) {
      any = any || node.transforms.size() > 1;
      std::reverse(node.transforms.begin(), node.transforms.end());
    }
    return any;
  });
  add_orders(list);
  const auto turned = [](Transform& t, float factor) {
    Rotate* const rotate = std::get_if<Rotate>(&t.map);
    if (rotate != nullptr) {
      rotate->angle_deg *= factor;
    }
    return rotate != nullptr && rotate->angle_deg != 0;
  };
  rewrite_each(list, "rotations turn the wrong way", [&](Transform& t) { return turned(t, -1); });
  rewrite_each(list, "angles of rotations in degrees are passed to functions that take radians",
               [&](Transform& t) { return turned(t, float(180 / pi)); });
  rewrite_each(list, "angles of rotations are converted to radians twice",
               [&](Transform& t) { return turned(t, float(pi / 180)); });
  rewrite_each(list, "angles of rotations are halved",
               [&](Transform& t) { return turned(t, 0.5f); });
  rewrite_each(list, "angles of rotations are doubled", [&](Transform& t) { return turned(t, 2); });
  for (const auto& [axis, name] :
       {std::pair(glm::vec3(1, 0, 0), "x"), std::pair(glm::vec3(0, 1, 0), "y"),
        std::pair(glm::vec3(0, 0, 1), "z")}) {
    rewrite_each(list, fmt::format("all rotations are about the {} axis", name).c_str(),
                 [axis = axis](Transform& t) {
                   Rotate* const rotate = std::get_if<Rotate>(&t.map);
                   const bool any = rotate != nullptr && rotate->axis != axis;
                   if (any) {
                     rotate->axis = axis;
                   }
                   return any;
                 });
  }
  rewrite_each(list, "rotations are ignored", drop<Rotate>);
  rewrite_each(list, "scalings are ignored", drop<Scale>);
  rewrite_each(list, "translations are ignored", drop<Translate>);
  for (const auto& [factor, what] : {std::pair(-1.0f, "translations go the wrong way"),
                                     std::pair(2.0f, "translations are applied twice"),
                                     std::pair(0.5f, "translations are halved")}) {
    rewrite_each(list, what, [factor = factor](Transform& t) {
      Translate* const move = std::get_if<Translate>(&t.map);
      if (move != nullptr) {
        move->by *= factor;
      }
      return move != nullptr;
    });
  }
  const auto scaled = [](Transform& t, glm::vec3 (*change)(const glm::vec3&)) {
    Scale* const scale = std::get_if<Scale>(&t.map);
    const glm::vec3 before = scale != nullptr ? scale->by : glm::vec3(1);
    const glm::vec3 after = change(before);
    if (scale != nullptr) {
      scale->by = after;
    }
    return before != after;
  };
  rewrite_each(list, "scalings are divided by, not multiplied by", [&](Transform& t) {
    return scaled(
        t, [](const glm::vec3& s) { return s.x != 0 && s.y != 0 && s.z != 0 ? 1.0f / s : s; });
  });
  rewrite_each(list, "scalings are applied twice",
               [&](Transform& t) { return scaled(t, [](const glm::vec3& s) { return s * s; }); });
  rewrite_each(list, "scalings use x for all three axes", [&](Transform& t) {
    return scaled(t, [](const glm::vec3& s) { return glm::vec3(s.x); });
  });
  rewrite_each(list, "matrices are ignored", drop<Matrix>);
  rewrite_each(list, "the axes of rotations are not normalized", [&](Transform& t) {
    // Like glm::rotate with an axis that is not normalized; approximated by a scaled angle.
    Rotate* const rotate = std::get_if<Rotate>(&t.map);
    if (rotate == nullptr || std::abs(glm::length(rotate->axis) - 1) < 1e-4f) {
      return false;
    }
    const glm::vec3 a = rotate->axis;
    const float s = std::sin(glm::radians(rotate->angle_deg));
    const float c = std::cos(glm::radians(rotate->angle_deg));
    glm::mat4 m(1);
    const glm::mat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);
    const glm::mat3 rotation = c * glm::mat3(1) + (1 - c) * glm::outerProduct(a, a) + s * cross;
    m[0] = glm::vec4(rotation[0], 0);
    m[1] = glm::vec4(rotation[1], 0);
    m[2] = glm::vec4(rotation[2], 0);
    t.map = Matrix(m);
    return true;
  });
  ignore_transforms(list, "transforms of outer blocks are ignored",
                    [](const Scene&, const Node& node) { return !node.children.empty(); });
  ignore_transforms(list, "transforms of blocks that show a template are ignored",
                    [](const Scene&, const Node& node) { return !node.instance_of.empty(); });
  ignore_transforms(
      list, "transforms of inner blocks replace those of outer ones",
      [](const Scene& scene, const Node& node) {
        return !node.children.empty() &&
               std::all_of(node.children.begin(), node.children.end(),
                           [&](NodeId child) { return !scene.nodes[child].transforms.empty(); });
      });
  ignore_transforms(list, "all transforms are ignored",
                    [](const Scene&, const Node&) { return true; });
  place_each(list, "matrices of nested blocks are multiplied in the wrong order",
             {.nesting_reversed = true});
  place_each(list, "all matrices are multiplied in the wrong order",
             {.nesting_reversed = true, .listed_reversed = true});
  place_each(list,
             "the matrix is not restored after a block: its transforms also apply to the next",
             {.not_restored = true});
  place_each(list, "object-to-world matrices are transposed", {.transposed = true});
  place_each(list, "matrices of the file are transposed", {.written_transposed = true});
  place_each(list, "rays are transformed by the object-to-world matrix, not by its inverse",
             {.inverted = true});
  place_each(list, "the inverse of matrices is computed as the transpose",
             {.inverse_by_transpose = true});
  place_each(list, "the origins of rays are transformed like directions (w = 0)",
             {.untranslated = true});
  static constexpr double max_unbounded = 1000;  // shapes that are met without bounding boxes
  if (count_virtual_primitives(list.scene) <= max_unbounded) {
    list.add(
        Cause::transforms,
        "the directions of rays are translated into object space, like points (w = 1)",
        [](Trial& t) { t.mistakes.directions = DirectionMistake::translated; }, Stage::hits);
    list.add(
        Cause::transforms, "the directions of rays are not transformed into object space",
        [](Trial& t) { t.mistakes.directions = DirectionMistake::of_world; }, Stage::hits);
  }
  list.add(Cause::transforms,
           "points are left in object space: light, shadow rays and reflections start there",
           [](Trial& t) { t.mistakes.object_points = true; });
  place_each(list, "lights are not moved by the transforms of their blocks", {.lights_stay = true});
  rewrite(list, "the last transform of each block is missing", [](Scene& scene) {
    bool any = false;
    for (Node& node : scene.nodes) {
      if (node.transforms.size() > 1) {
        node.transforms.pop_back();
        any = true;
      }
    }
    return any;
  });
  rewrite(list, "the first transform of each block is missing", [](Scene& scene) {
    bool any = false;
    for (Node& node : scene.nodes) {
      if (node.transforms.size() > 1) {
        node.transforms.erase(node.transforms.begin());
        any = true;
      }
    }
    return any;
  });
}

}  // namespace scenefile
