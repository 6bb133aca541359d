#include "scenefile/viewer/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace scenefile::viewer {

namespace {

/// Looks up which source a place in the file became.
class SourcesByPlace {
 public:
  explicit SourcesByPlace(const std::vector<Source>& sources) {
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
      const Location& l = sources[i].location;
      sources_.emplace(std::pair(l.line, l.column), i);
    }
  }
  std::uint32_t find(const Location& location) const {
    const auto found = sources_.find({location.line, location.column});
    return found == sources_.end() || !location.known() ? no_index : found->second;
  }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sources_;
};

std::string light_label(const Light& light) {
  return light.name.empty() ? fmt::format("{} light", word_of(light.type)) : light.name;
}

std::string primitive_detail(const Primitive& primitive) {
  const auto& texture = primitive.material.texture;
  return !primitive.mesh_file.empty() ? primitive.mesh_file.str()
         : texture                    ? texture->file
                                      : std::string();
}

class OutlineMaker {
 public:
  OutlineMaker(const Scene& scene, const Prepared& ready) : scene_(scene), places_(ready.sources) {
    outline_.row_of_source.assign(ready.sources.size(), no_index);
  }

  Outline make() {
    add_camera();
    add_tree(scene_.root, 0, scene_.name.empty() ? "scene" : scene_.name);
    if (!scene_.templates.empty()) {
      const std::uint32_t row = add({RowKind::templates, 0, 0, 0, "templates"});
      for (const NodeId id : scene_.templates) {
        add_tree(id, 1, "template");
      }
      close(row);
    }
    return std::move(outline_);
  }

 private:
  struct Step {
    NodeId node = 0;
    std::uint32_t row = no_index;  ///< to be closed; else the node is to be added
    std::uint32_t depth = 0;
  };

  std::uint32_t add(OutlineRow row) {
    const auto index = static_cast<std::uint32_t>(outline_.rows.size());
    row.end = index + 1;
    while (!open_.empty() && outline_.rows[open_.back()].depth >= row.depth) {
      open_.pop_back();
    }
    row.parent = open_.empty() ? index : open_.back();
    open_.push_back(index);
    if (row.source != no_index) {
      outline_.row_of_source[row.source] = index;
    }
    outline_.rows.push_back(std::move(row));
    return index;
  }
  void close(std::uint32_t row) {
    outline_.rows[row].end = static_cast<std::uint32_t>(outline_.rows.size());
  }

  void add_camera() {
    if (scene_.camera) {
      add({RowKind::camera, 0, 0, 0, "camera", "", scene_.camera->location});
    }
  }

  // Depth first, children behind lights and primitives, without recursion.
  void add_tree(NodeId head, std::uint32_t depth, const std::string& name) {
    std::vector<Step> steps{{head, no_index, depth}};
    while (!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      if (step.row != no_index) {
        close(step.row);
        continue;
      }
      const Node& node = scene_.nodes[step.node];
      const std::uint32_t row = add_node(node, step.depth, step.node == head ? name : "group");
      steps.push_back({0, row, 0});
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        steps.push_back({*child, no_index, step.depth + 1});
      }
    }
  }

  // What a group without a name holds, in a few words.
  std::string contents_of(const Node& node) const {
    constexpr std::size_t most = 3;
    std::vector<std::string> words;
    for (const Primitive& primitive : node.primitives) {
      words.emplace_back(word_of(primitive.shape));
    }
    for (const NodeId child : node.children) {
      const Node& inner = scene_.nodes[child];
      const std::string& name = inner.name.empty() ? inner.instance_of : inner.name;
      words.push_back(!name.empty() ? name
                      : inner.primitives.size() == 1
                          ? std::string(word_of(inner.primitives.front().shape))
                          : "group");
    }
    const std::size_t all = words.size();
    words.resize(std::min(all, most));
    return fmt::format("{}{}", fmt::join(words, ", "), all > most ? ", ..." : "");
  }

  std::uint32_t add_node(const Node& node, std::uint32_t depth, const std::string& otherwise) {
    OutlineRow row{RowKind::group, depth};
    row.label = node.name.empty() ? otherwise : node.name.str();
    row.detail = node.name.empty() ? contents_of(node) : std::string();
    row.location = node.location;
    if (!node.instance_of.empty()) {
      row.kind = RowKind::copy;
      row.label = node.name.empty() ? node.instance_of.str() : node.name.str();
      row.detail = node.name.empty() ? "copy" : "copy of " + node.instance_of.str();
      row.source = places_.find(node.location);
    }
    const std::uint32_t index = add(std::move(row));
    for (const Light& light : node.lights) {
      add({RowKind::light, depth + 1, 0, 0, light_label(light), "", light.location,
           places_.find(light.location)});
    }
    for (const Primitive& primitive : node.primitives) {
      add({RowKind::primitive, depth + 1, 0, 0, std::string(word_of(primitive.shape)),
           primitive_detail(primitive), primitive.location, places_.find(primitive.location)});
    }
    return index;
  }

  const Scene& scene_;
  SourcesByPlace places_;
  Outline outline_;
  std::vector<std::uint32_t> open_;  ///< the rows around the last one, and itself
};

/// A row among those of one parent: the parent, and what is the same in all versions.
struct RowKey {
  std::uint32_t parent = no_index;  ///< at the top no_index
  RowKind kind = RowKind::group;
  std::string_view label;
  std::string_view detail;

  auto operator<=>(const RowKey&) const = default;
};

RowKey key_of(const OutlineRow& row, std::uint32_t index, std::uint32_t parent) {
  return {row.parent == index ? no_index : parent, row.kind, row.label, row.detail};
}

}  // namespace

std::vector<std::uint32_t> match_rows(const Outline& before, const Outline& after) {
  std::map<RowKey, std::vector<std::uint32_t>> rows_of_key;
  for (std::uint32_t i = 0; i < after.rows.size(); ++i) {
    const OutlineRow& row = after.rows[i];
    rows_of_key[key_of(row, i, row.parent)].push_back(i);
  }
  std::map<RowKey, std::size_t> taken;
  std::vector<std::uint32_t> matches(before.rows.size(), no_index);
  for (std::uint32_t i = 0; i < before.rows.size(); ++i) {
    const OutlineRow& row = before.rows[i];
    if (row.parent != i && matches[row.parent] == no_index) {
      continue;
    }
    const RowKey key = key_of(row, i, matches[row.parent]);
    const auto found = rows_of_key.find(key);
    if (found != rows_of_key.end() && taken[key] < found->second.size()) {
      matches[i] = found->second[taken[key]++];
    }
  }
  return matches;
}

Outline make_outline(const Scene& scene, const Prepared& ready) {
  return OutlineMaker(scene, ready).make();
}

std::vector<std::uint32_t> visible_rows(const Outline& outline,
                                        const std::set<std::uint32_t>& open) {
  std::vector<std::uint32_t> visible;
  for (std::uint32_t row = 0; row < outline.rows.size();) {
    visible.push_back(row);
    row = open.contains(row) ? row + 1 : outline.rows[row].end;
  }
  return visible;
}

std::set<std::uint32_t> sources_in(const Outline& outline, std::uint32_t row) {
  std::set<std::uint32_t> sources;
  for (std::uint32_t i = row; i < outline.rows[row].end; ++i) {
    if (outline.rows[i].source != no_index) {
      sources.insert(outline.rows[i].source);
    }
  }
  return sources;
}

std::vector<std::uint32_t> rows_around(const Outline& outline, std::uint32_t row) {
  std::vector<std::uint32_t> around;
  for (std::uint32_t i = row; outline.rows[i].parent != i;) {
    i = outline.rows[i].parent;
    around.insert(around.begin(), i);
  }
  return around;
}

}  // namespace scenefile::viewer
