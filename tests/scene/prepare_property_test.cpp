// Laws of prepare() and flattened() on random scenes, compared with a plain recursive expansion
// that shares no code with them.
#include "builders.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/flatten.h"
#include "scenefile/scene/prepare.h"
#include "scenefile/scene/summary.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <vector>

using namespace scenefile;
using namespace scenefile::test;

namespace {

using Random = std::mt19937;

int draw(Random& random, int below) {
  return static_cast<int>(random() % static_cast<unsigned>(below));
}

float number(Random& random) {
  return static_cast<float>(draw(random, 41) - 20) / 8;
}

Transform random_transform(Random& random) {
  const auto factor = [&] { return number(random) + (draw(random, 2) != 0 ? 3.1f : -3.1f); };
  switch (draw(random, 4)) {
    case 0:
      return translate(number(random), number(random), number(random));
    case 1:
      return scale(factor(), factor(), factor());
    case 2:
      return rotate({1, number(random), number(random)}, 45 * number(random));
    default: {
      glm::mat4 m(1);
      m[0] = glm::vec4(2, number(random) / 9, 0, 0);
      m[3] = glm::vec4(number(random), 1, number(random), 1);
      return matrix(m);
    }
  }
}

// Templates only use earlier ones; few names, so that they collide.
Scene random_scene(Random& random) {
  Scene scene;
  scene.nodes[0].name = "root";
  const int templates = draw(random, 5);
  for (int tree = 0; tree <= templates; ++tree) {
    const NodeId head = tree == templates ? scene.root : add_template(scene, numbered(tree));
    std::vector<NodeId> groups = {head};
    for (int i = draw(random, 8); i > 0; --i) {
      const NodeId parent = groups[static_cast<std::size_t>(draw(random, int(groups.size())))];
      const NodeId node = add_group(scene, parent);
      for (int t = draw(random, 4); t > 0; --t) {
        scene.nodes[node].transforms.push_back(random_transform(random));
      }
      if (tree > 0 && draw(random, 3) == 0) {
        scene.nodes[node].instance_of = numbered(draw(random, tree));
        continue;
      }
      groups.push_back(node);
      for (int p = draw(random, 3); p > 0; --p) {
        Primitive added = primitive(static_cast<Shape>(draw(random, 4)));
        added.material.shininess = static_cast<float>(draw(random, 5));
        scene.nodes[node].primitives.push_back(added);
      }
      if (draw(random, 4) == 0) {
        scene.nodes[node].lights.push_back(
            point_light({number(random), number(random), number(random)}));
      }
    }
  }
  return scene;
}

struct Drawn {
  glm::dmat4 world_from_object;
  Shape shape;
  float shininess;
};

struct Expansion {
  std::vector<Drawn> primitives;
  std::vector<glm::dvec3> lights;
};

glm::dmat4 matrix_of(const Transform& t) {
  const glm::dmat4 one(1);
  if (const auto* m = std::get_if<Translate>(&t.map)) {
    return glm::translate(one, glm::dvec3(m->by));
  }
  if (const auto* m = std::get_if<Scale>(&t.map)) {
    return glm::scale(one, glm::dvec3(m->by));
  }
  if (const auto* m = std::get_if<Rotate>(&t.map)) {
    return glm::rotate(one, glm::radians(double(m->angle_deg)), glm::dvec3(m->axis));
  }
  return glm::dmat4(std::get<Matrix>(t.map).m());
}

void expand(const Scene& scene, NodeId id, glm::dmat4 world, Expansion& out) {
  const Node& node = scene.nodes[id];
  for (const Transform& t : node.transforms) {
    world = world * matrix_of(t);
  }
  for (const Primitive& p : node.primitives) {
    out.primitives.push_back({world, p.shape, p.material.shininess});
  }
  for (const Light& light : node.lights) {
    out.lights.push_back(glm::dvec3(world * glm::dvec4(light.position, 1)));
  }
  for (const NodeId child : node.children) {
    expand(scene, child, world, out);
  }
  for (const NodeId head : scene.templates) {
    if (scene.nodes[head].name == node.instance_of) {
      expand(scene, head, world, out);
    }
  }
}

void expand(const RenderScene& scene, std::uint32_t g, const DAffine& world, Expansion& out) {
  for (const RenderPrimitive& p : scene.groups[g].primitives) {
    const DAffine map = world * DAffine(p.group_from_object);
    glm::dmat4 m(map.linear);
    m[3] = glm::dvec4(map.offset, 1);
    out.primitives.push_back({m, p.shape, scene.materials[p.material].shininess});
  }
  for (const RenderInstance& instance : scene.groups[g].instances) {
    expand(scene, instance.group, world * DAffine(instance.group_from_instance), out);
  }
}

bool near(const glm::dmat4& a, const glm::dmat4& b) {
  double size = 1;
  double error = 0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      size = std::max(size, std::abs(a[c][r]));
      error = std::max(error, std::abs(a[c][r] - b[c][r]));
    }
  }
  return error <= 1e-5 * size;
}

// Whether the two lists are equal as multisets.
template <typename T, typename Same>
bool same_set(const std::vector<T>& a, std::vector<T> b, Same same) {
  for (const T& item : a) {
    const auto found =
        std::find_if(b.begin(), b.end(), [&](const T& other) { return same(item, other); });
    if (found == b.end()) {
      return false;
    }
    *found = b.back();
    b.pop_back();
  }
  return b.empty();
}

// Puts an unnamed group without transforms around a random child.
void insert_identity_group(Scene& scene, Random& random) {
  const auto parent = static_cast<NodeId>(draw(random, int(scene.nodes.size())));
  if (scene.nodes[parent].children.empty()) {
    return;
  }
  const auto place =
      static_cast<std::size_t>(draw(random, int(scene.nodes[parent].children.size())));
  const NodeId child = scene.nodes[parent].children[place];
  const auto group = static_cast<NodeId>(scene.nodes.size());
  scene.nodes.emplace_back();
  scene.nodes[group].children = {child};
  scene.nodes[parent].children[place] = group;
}

// Moves the last transforms of a node, with its contents, into a new child.
void cut_transforms(Scene& scene, Random& random) {
  const auto id = static_cast<NodeId>(draw(random, int(scene.nodes.size())));
  const auto inner = static_cast<NodeId>(scene.nodes.size());
  scene.nodes.emplace_back();
  Node& outer = scene.nodes[id];
  Node moved = outer;
  moved.name.clear();
  const long cut = draw(random, int(outer.transforms.size()) + 1);
  moved.transforms.erase(moved.transforms.begin(), moved.transforms.begin() + cut);
  outer.transforms.erase(outer.transforms.begin() + cut, outer.transforms.end());
  outer.lights.clear();
  outer.primitives.clear();
  outer.instance_of.clear();
  outer.children = {inner};
  scene.nodes[inner] = std::move(moved);
}

template <typename Law>
void holds(const char* text, Law law) {
  EXPECT_TRUE(rc::check(text, [&] {
    Random random(*rc::gen::arbitrary<unsigned>());
    law(random_scene(random), random);
  }));
}

}  // namespace

TEST(PrepareLaws, EqualsPlainExpansion) {
  holds("prepare draws what plain recursion draws", [](const Scene& scene, Random&) {
    Expansion expected;
    expand(scene, scene.root, glm::dmat4(1), expected);
    const RenderScene ready = prepare(scene, Limits{}).scene;
    Expansion got;
    expand(ready, ready.root, DAffine(), got);
    RC_ASSERT(same_set(expected.primitives, got.primitives, [](const Drawn& a, const Drawn& b) {
      return a.shape == b.shape && a.shininess == b.shininess &&
             near(a.world_from_object, b.world_from_object);
    }));
    RC_ASSERT(count_virtual_primitives(ready) == double(expected.primitives.size()));
    RC_ASSERT(summarize(scene).virtual_primitives == double(expected.primitives.size()));
    std::vector<glm::dvec3> lights;
    for (const RenderLight& light : ready.lights) {
      lights.push_back(glm::dvec3(light.position));
    }
    RC_ASSERT(same_set(expected.lights, lights, [](glm::dvec3 a, glm::dvec3 b) {
      return glm::length(a - b) <= 1e-5 * (1 + glm::length(a));
    }));
  });
}

TEST(PrepareLaws, GroupsAreInOrderAndNotEmpty) {
  holds("groups come after those that they contain, and draw something",
        [](const Scene& scene, Random&) {
          const RenderScene ready = prepare(scene, Limits{}).scene;
          RC_ASSERT(ready.root == ready.groups.size() - 1);
          for (std::uint32_t g = 0; g < ready.groups.size(); ++g) {
            const RenderGroup& group = ready.groups[g];
            RC_ASSERT(g == ready.root || !group.primitives.empty() || !group.instances.empty());
            for (const RenderInstance& instance : group.instances) {
              RC_ASSERT(instance.group < g);
              RC_ASSERT(invertible(DAffine(instance.group_from_instance)));
            }
          }
        });
}

TEST(PrepareLaws, IdentityGroupsDoNotMatter) {
  holds("groups without transforms change nothing", [](const Scene& scene, Random& random) {
    Scene wrapped = scene;
    for (int i = 0; i < 5; ++i) {
      insert_identity_group(wrapped, random);
    }
    RC_ASSERT(same_meaning(scene, wrapped));
  });
}

TEST(PrepareLaws, TheNodeOfATransformDoesNotMatter) {
  holds("a list of transforms means the same in one node and in two",
        [](const Scene& scene, Random& random) {
          Scene cut = scene;
          for (int i = 0; i < 5; ++i) {
            cut_transforms(cut, random);
          }
          RC_ASSERT(same_meaning(scene, cut));
        });
}

TEST(FlattenLaws, GroupsDoNotMatter) {
  holds("a scene means the same without its groups", [](const Scene& scene, Random&) {
    Spellings spellings;
    const std::optional<Scene> flat = flattened(scene, spellings);
    RC_ASSERT(flat && same_meaning(scene, *flat));
    for (const NodeId head : flat->templates) {
      for (const NodeId child : flat->nodes[head].children) {
        RC_ASSERT(flat->nodes[child].children.empty());
      }
    }
  });
}

TEST(FlattenLaws, TransformsAreSpelledAsInTheFirstScene) {
  holds("two scenes with other groups are the same scene without them",
        [](const Scene& scene, Random& random) {
          Scene other = scene;
          for (int i = 0; i < 5; ++i) {
            insert_identity_group(other, random);
            cut_transforms(other, random);
          }
          Spellings spellings;
          const std::optional<Scene> flat = flattened(scene, spellings);
          RC_ASSERT(flat == flattened(other, spellings));
        });
}
