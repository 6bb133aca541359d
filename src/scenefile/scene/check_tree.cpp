#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/codes.h"
#include "scenefile/scene/template_graph.h"
#include "scenefile/scene/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

constexpr double lights_of_the_format = 8;
// Each suggestion compares with every name; this keeps a file with many wrong names linear.
constexpr std::size_t max_suggestions = 100;
constexpr std::size_t max_names = 1000;
constexpr std::size_t max_loop_names = 8;

Subject subject_of(const Scene& scene, NodeId id) {
  return {"node", scene.nodes[id].location, id};
}

void check_names(const Scene& scene, const TemplateNames& names, Reporter& reporter) {
  for (std::uint32_t i = 0; i < scene.templates.size(); ++i) {
    const NodeId id = scene.templates[i];
    if (id >= scene.nodes.size()) {
      continue;
    }
    const std::string& name = scene.nodes[id].name;
    if (name.empty()) {
      reporter.report("tree.template-without-name"_code, subject_of(scene, id),
                      "a template needs a name, by which it is used");
      continue;
    }
    const std::uint32_t first = names.at(name);
    if (first != i) {
      const Location place = scene.nodes[scene.templates[first]].location;
      reporter.report("tree.duplicate-template"_code, subject_of(scene, id),
                      fmt::format("the name {} belongs to an earlier template{} too", quoted(name),
                                  place.known() ? fmt::format(" (line {})", place.line) : ""));
    }
  }
}

std::vector<std::string_view> some_names(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const NodeId id : scene.templates) {
    if (names.size() < max_names && id < scene.nodes.size()) {
      names.push_back(scene.nodes[id].name);
    }
  }
  return names;
}

std::string unknown_text(std::string_view name, std::string_view near) {
  if (name == "root") {
    return "\"root\" is the scene itself, which cannot be inside itself";
  }
  return fmt::format("there is no template named {}{}", quoted(name),
                     near.empty() ? "" : fmt::format("; did you mean {}?", quoted(near)));
}

// Returns whether every instance has its template.
bool check_instances(const Scene& scene, const TemplateNames& names,
                     const std::vector<NodeId>& instances, Reporter& reporter) {
  const std::vector<std::string_view> known = some_names(scene);
  std::size_t unknown = 0;
  for (const NodeId id : instances) {
    const Node& node = scene.nodes[id];
    if (names.find(node.instance_of) == names.end()) {
      const bool suggest = ++unknown <= max_suggestions;
      const std::string_view near = suggest && node.instance_of != "root"
                                        ? nearest_name(node.instance_of, known)
                                        : std::string_view();
      reporter.report("tree.unknown-template"_code, subject_of(scene, id), Field::instance_of,
                      unknown_text(node.instance_of, near),
                      correction(node.instance_of, near, known));
    }
    if (!node.primitives.empty() || !node.lights.empty() || !node.children.empty()) {
      reporter.report(
          "tree.instance-with-contents"_code, subject_of(scene, id),
          fmt::format("contents inside an instance of {} are ignored", quoted(node.instance_of)));
    }
  }
  return unknown == 0;
}

// "a -> b -> a", shortened in the middle if it is long.
std::string loop_text(const Scene& scene, const TemplateGraph& graph,
                      std::span<const std::uint32_t> loop) {
  std::string text;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop.size() > max_loop_names && i == max_loop_names / 2) {
      text += "... -> ";
      i = loop.size() - max_loop_names / 2;
    }
    text += escaped(scene.nodes[graph.heads[loop[i]]].name, 40) + " -> ";
  }
  return text + escaped(scene.nodes[graph.heads[loop[0]]].name, 40);
}

// Returns whether there are loops; marks the trees that the root uses.
bool check_loops(const Scene& scene, const TemplateGraph& graph, Reporter& reporter,
                 std::vector<bool>& used) {
  bool found = false;
  const auto loop = [&](std::span<const std::uint32_t> way, std::uint32_t edge) {
    found = true;
    reporter.report(
        "tree.loop"_code, subject_of(scene, graph.use_node[edge]), Field::instance_of,
        fmt::format("template {} contains itself: {}",
                    quoted(scene.nodes[graph.heads[way[0]]].name), loop_text(scene, graph, way)));
  };
  const auto use = [&](std::uint32_t tree) { used[tree] = true; };
  const std::uint32_t root = graph.root();
  visit_depth_first(graph.uses, std::span(&root, 1), use,
                    [](std::span<const std::uint32_t>, std::uint32_t) {});
  std::vector<std::uint32_t> all(graph.heads.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    all[i] = i;
  }
  visit_depth_first(
      graph.uses, all, [](std::uint32_t) {}, loop);
  return found;
}

// The root may use templates that are declared after it: it is last in the list.
void check_order(const Scene& scene, const TemplateGraph& graph, Reporter& reporter) {
  for (std::uint32_t tree = 0; tree < graph.root(); ++tree) {
    for (std::uint32_t edge = graph.uses.first[tree]; edge < graph.uses.first[tree + 1]; ++edge) {
      const std::uint32_t target = graph.uses.target[edge];
      if (target <= tree) {
        continue;
      }
      const Node& used = scene.nodes[graph.heads[target]];
      reporter.report(
          "tree.used-before-declared"_code, subject_of(scene, graph.use_node[edge]),
          Field::instance_of,
          fmt::format("template {} is used before it is declared{}", quoted(used.name),
                      used.location.known() ? fmt::format(" (line {})", used.location.line) : ""));
    }
  }
}

// The contents of each tree itself, without those of its instances.
struct Contents {
  std::vector<double> primitives;
  std::vector<double> lights;
  std::vector<double> shining;
  Subject last_light;  // the one that exceeds the format's limit, or the last one
  const Primitive* transparent = nullptr;
  NodeId transparent_node = no_node;
};

Contents contents_of(const Scene& scene, const TemplateGraph& graph,
                     const std::vector<bool>& used) {
  Contents contents;
  double lights = 0;
  std::vector<bool> seen(scene.nodes.size());
  for (std::size_t tree = 0; tree < graph.heads.size(); ++tree) {
    double own_lights = 0;
    double own_shining = 0;
    double own_primitives = 0;
    walk_nodes(scene, graph.heads[tree], 0, seen, [&](NodeId id, int) {
      const Node& node = scene.nodes[id];
      if (!used[tree] || !node.instance_of.empty()) {
        return 0;
      }
      for (const Light& light : node.lights) {
        own_lights += 1;
        own_shining += largest(light.color) > 0 ? 1 : 0;
        if (++lights <= lights_of_the_format + 1) {
          contents.last_light = {"light", light.location, id};
        }
      }
      for (const Primitive& primitive : node.primitives) {
        if (contents.transparent == nullptr && largest(primitive.material.transparent) > 0) {
          contents.transparent = &primitive;
          contents.transparent_node = id;
        }
      }
      own_primitives += static_cast<double>(node.primitives.size());
      return 0;
    });
    contents.primitives.push_back(own_primitives);
    contents.lights.push_back(own_lights);
    contents.shining.push_back(own_shining);
  }
  return contents;
}

void check_light_count(double lights, const Contents& contents, const Limits& limits,
                       Reporter& reporter) {
  if (lights > limits.lights) {
    reporter.report("light.count-limit"_code, contents.last_light,
                    fmt::format("the scene has {:.15g} lights, more than the limit of {}", lights,
                                limits.lights));
  } else if (lights > lights_of_the_format) {
    reporter.report(
        "light.many"_code, contents.last_light,
        fmt::format("the scene has {:.15g} lights, more than the 8 of the format", lights));
  }
}

void check_totals(const Scene& scene, const TemplateGraph& graph, const Contents& contents,
                  bool complete, const Limits& limits, Reporter& reporter) {
  const Subject whole{
      "scene", scene.root < scene.nodes.size() ? scene.nodes[scene.root].location : Location{}};
  const double lights = totals(graph.uses, contents.lights).back();
  check_light_count(lights, contents, limits, reporter);
  const bool empty = totals(graph.uses, contents.primitives).back() == 0;
  if (empty && complete) {
    reporter.report("scene.empty"_code, whole, "the scene is empty: there is no object to draw");
  } else if (!empty && totals(graph.uses, contents.shining).back() == 0) {
    reporter.report("scene.no-light"_code, whole,
                    lights == 0 ? "the scene has no light" : "all lights of the scene are black");
  }
  const std::uint32_t nesting = heights(graph.uses).back();
  if (nesting > limits.instance_nesting) {
    reporter.report("tree.nesting-limit"_code, whole,
                    fmt::format("templates are nested {} deep, more than the limit of {}", nesting,
                                limits.instance_nesting));
  }
  if (contents.transparent != nullptr && !scene.global.transparent &&
      !scene.global.unread.contains(Field::transparent)) {
    reporter.report("global.transparent-default"_code,
                    {"primitive", contents.transparent->location, contents.transparent_node},
                    Field::transparent,
                    fmt::format("the {} is transparent, but the file gives no transparentcoeff; "
                                "0.5 is used (0 in the profile course)",
                                word_of(contents.transparent->shape)));
  }
}

void check_unused(const Scene& scene, const TemplateGraph& graph, const std::vector<bool>& used,
                  Reporter& reporter) {
  for (std::uint32_t tree = 0; tree < graph.root(); ++tree) {
    const NodeId head = graph.heads[tree];
    if (!used[tree] && head < scene.nodes.size() && !scene.nodes[head].name.empty()) {
      reporter.report("tree.unused-template"_code, subject_of(scene, head),
                      fmt::format("template {} is never used", quoted(scene.nodes[head].name)));
    }
  }
}

}  // namespace

void check_structure(const Scene& scene, Reporter& reporter) {
  std::vector<bool> seen(scene.nodes.size());
  std::vector<NodeId> pending;
  const auto add = [&](NodeId id, NodeId holder, std::string_view what) {
    const Subject subject = holder == no_node ? Subject{"scene", {}} : subject_of(scene, holder);
    if (id >= scene.nodes.size()) {
      reporter.report(
          "scene.bad-index"_code, subject,
          fmt::format("{} is node {}, but there are only {} nodes", what, id, scene.nodes.size()));
    } else if (seen[id]) {
      reporter.report("scene.shared-node"_code, subject,
                      fmt::format("{} is node {}, which is already part of the scene", what, id));
    } else {
      seen[id] = true;
      pending.push_back(id);
    }
  };
  add(scene.root, no_node, "the root");
  for (const NodeId id : scene.templates) {
    add(id, no_node, "a template");
  }
  while (!pending.empty()) {
    const NodeId holder = pending.back();
    pending.pop_back();
    for (const NodeId child : scene.nodes[holder].children) {
      add(child, holder, "a child");
    }
  }
}

void check_templates(const Scene& scene, const Limits& limits, Reporter& reporter) {
  const TemplateNames names = template_names(scene);
  check_names(scene, names, reporter);
  const TemplateGraph graph = template_graph(scene);
  const bool all_known = check_instances(scene, names, graph.instances, reporter);
  std::vector<bool> used(graph.heads.size());
  const bool loops = check_loops(scene, graph, reporter, used);
  if (!loops) {
    check_order(scene, graph, reporter);
  }
  // Parts that could not be read may contain anything.
  const bool complete = all_known && !loops;
  check_totals(scene, graph, contents_of(scene, graph, used), complete, limits, reporter);
  check_unused(scene, graph, used, reporter);
}

}  // namespace scenefile
