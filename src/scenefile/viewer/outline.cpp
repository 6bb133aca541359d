#include "scenefile/viewer/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace scenefile::viewer {

namespace {

std::string light_label(const Light& light) {
  return light.name.empty() ? fmt::format("{} light", word_of(light.type)) : light.name;
}

std::string primitive_detail(const Primitive& primitive) {
  const auto& texture = primitive.material.texture;
  return !primitive.mesh_file.empty() ? primitive.mesh_file.str()
         : texture                    ? texture->file
                                      : std::string();
}

/// "cylinder ×6, cone": words in order of first occurrence.
class WordCounts {
 public:
  void add(const std::string& word) {
    const auto known = std::find_if(words_.begin(), words_.end(),
                                    [&](const auto& counted) { return counted.first == word; });
    if (known != words_.end()) {
      ++known->second;
    } else if (words_.size() < most) {
      words_.emplace_back(word, 1);
    } else {
      more_ = true;
    }
  }
  std::string text() const {
    std::string text;
    for (const auto& [word, count] : words_) {
      text.append(text.empty() ? "" : ", ").append(word);
      if (count > 1) {
        text += fmt::format(" \u00d7{}", count);
      }
    }
    return text + (more_ ? ", ..." : "");
  }

 private:
  static constexpr std::size_t most = 3;
  std::vector<std::pair<std::string, int>> words_;
  bool more_ = false;
};

class OutlineMaker {
 public:
  explicit OutlineMaker(const Scene& scene)
      : scene_(scene), row_of_node_(scene.nodes.size(), no_index) {}

  Outline make(const std::vector<Source>& sources) {
    add({RowKind::globals, 0, 0, 0, "global data"});
    add_camera();
    add_tree(scene_.root, 0, scene_.name.empty() ? "scene" : scene_.name);
    if (!scene_.templates.empty()) {
      const std::uint32_t row = add({RowKind::templates, 0, 0, 0, "templates"});
      for (const NodeId id : scene_.templates) {
        add_tree(id, 1, "template");
      }
      close(row);
    }
    number_sources(sources);
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
    outline_.rows.push_back(std::move(row));
    return index;
  }
  void close(std::uint32_t row) {
    outline_.rows[row].end = static_cast<std::uint32_t>(outline_.rows.size());
  }

  // The rows of a node: its own, those of its lights, those of its primitives.
  void number_sources(const std::vector<Source>& sources) {
    outline_.row_of_source.assign(sources.size(), no_index);
    for (std::uint32_t i = 0; i < sources.size(); ++i) {
      const Source& source = sources[i];
      if (row_of_node_[source.node] == no_index) {
        continue;
      }
      std::uint32_t row = row_of_node_[source.node];
      if (source.kind != SourceKind::instance) {
        row += 1 + source.index;
      }
      if (source.kind == SourceKind::primitive) {
        row += static_cast<std::uint32_t>(scene_.nodes[source.node].lights.size());
      }
      outline_.row_of_source[i] = row;
      outline_.rows[row].source = i;
    }
  }

  void add_camera() {
    if (scene_.camera) {
      add({RowKind::camera, 0, 0, 0, "camera", "", scene_.camera->location});
    } else {
      add({RowKind::camera, 0, 0, 0, "camera", "default"});
    }
  }

  // Depth first, without recursion; children come after lights and primitives.
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
      const std::uint32_t row = add_node(step.node, step.depth, step.node == head ? name : "group");
      steps.push_back({0, row, 0});
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
        steps.push_back({*child, no_index, step.depth + 1});
      }
    }
  }

  // The name of a node, or of the only thing in it.
  std::string word_for(const Node& node) const {
    const std::string& name = node.name.empty() ? node.instance_of : node.name;
    if (!name.empty()) {
      return name;
    }
    if (node.children.empty() && node.lights.size() + node.primitives.size() == 1) {
      return node.lights.empty() ? std::string(word_of(node.primitives.front().shape))
                                 : light_label(node.lights.front());
    }
    return "group";
  }

  // A summary of the contents of an unnamed group.
  std::string contents_of(const Node& node) const {
    WordCounts words;
    for (const Light& light : node.lights) {
      words.add(light_label(light));
    }
    for (const Primitive& primitive : node.primitives) {
      words.add(std::string(word_of(primitive.shape)));
    }
    for (const NodeId child : node.children) {
      words.add(word_for(scene_.nodes[child]));
    }
    return words.text();
  }

  std::uint32_t add_node(NodeId id, std::uint32_t depth, const std::string& otherwise) {
    const Node& node = scene_.nodes[id];
    OutlineRow row{RowKind::group, depth};
    row.label = node.name.empty() ? otherwise : node.name.str();
    row.detail = node.name.empty() ? contents_of(node) : std::string();
    row.location = node.location;
    if (!node.instance_of.empty()) {
      row.kind = RowKind::copy;
      row.label = node.name.empty() ? node.instance_of.str() : node.name.str();
      row.detail = node.name.empty() ? "copy" : "copy of " + node.instance_of.str();
    }
    const std::uint32_t index = row_of_node_[id] = add(std::move(row));
    for (const Light& light : node.lights) {
      add({RowKind::light, depth + 1, 0, 0, light_label(light), "", light.location});
    }
    for (const Primitive& primitive : node.primitives) {
      add({RowKind::primitive, depth + 1, 0, 0, std::string(word_of(primitive.shape)),
           primitive_detail(primitive), primitive.location});
    }
    return index;
  }

  const Scene& scene_;
  std::vector<std::uint32_t> row_of_node_;
  Outline outline_;
  std::vector<std::uint32_t> open_;  ///< the rows around the last one, and itself
};

/// Matches the rows of two versions of a scene, parents first.
class RowMatcher {
 public:
  RowMatcher(const Outline& before, const Outline& after)
      : before_(before),
        after_(after),
        matches_(before.rows.size(), no_index),
        taken_(after.rows.size(), false) {}

  std::vector<std::uint32_t> match() {
    match_siblings(rows_from(before_, 0, before_.rows.size()),
                   rows_from(after_, 0, after_.rows.size()));
    for (std::uint32_t row = 0; row < before_.rows.size(); ++row) {
      const std::uint32_t now = matches_[row];
      if (now != no_index) {
        match_siblings(rows_from(before_, row + 1, before_.rows[row].end),
                       rows_from(after_, now + 1, after_.rows[now].end));
      }
    }
    return std::move(matches_);
  }

 private:
  using Rows = std::vector<std::uint32_t>;
  using Key = std::tuple<RowKind, std::string_view, std::string_view>;

  // The outermost rows in a range.
  static Rows rows_from(const Outline& outline, std::size_t begin, std::size_t end) {
    Rows rows;
    for (std::size_t row = begin; row < end; row = outline.rows[row].end) {
      rows.push_back(static_cast<std::uint32_t>(row));
    }
    return rows;
  }

  // Matches unchanged rows first, so that changed rows are not mistaken for them.
  void match_siblings(const Rows& before, const Rows& after) {
    match_siblings(before, after, true);
    match_siblings(before, after, false);
  }
  void match_siblings(const Rows& before, const Rows& after, bool with_detail) {
    const auto key_of = [&](const OutlineRow& row) {
      return Key(row.kind, row.label, with_detail ? row.detail : std::string_view());
    };
    std::map<Key, Rows> free;
    for (auto row = after.rbegin(); row != after.rend(); ++row) {
      if (!taken_[*row]) {
        free[key_of(after_.rows[*row])].push_back(*row);
      }
    }
    for (const std::uint32_t row : before) {
      Rows& same = free[key_of(before_.rows[row])];
      if (matches_[row] == no_index && !same.empty()) {
        matches_[row] = same.back();
        taken_[same.back()] = true;
        same.pop_back();
      }
    }
  }

  const Outline& before_;
  const Outline& after_;
  std::vector<std::uint32_t> matches_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<std::uint32_t> match_rows(const Outline& before, const Outline& after) {
  return RowMatcher(before, after).match();
}

Outline make_outline(const Scene& scene, const Prepared& ready) {
  return OutlineMaker(scene).make(ready.sources);
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

bool has_sources(const Outline& outline, std::uint32_t row) {
  const auto first = outline.rows.begin() + row;
  const auto end = outline.rows.begin() + outline.rows[row].end;
  return std::any_of(first, end, [](const OutlineRow& r) { return r.source != no_index; });
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
