#include "format/answer.h"

#include "format/reading.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <variant>
#include <vector>

namespace scenefile::testing {
namespace {

std::string text_of(Location place) {
  return fmt::format("{}:{}", place.line, place.column);
}

std::string text_of(float value) {
  return fmt::format("{}", value);
}
std::string text_of(int value) {
  return fmt::format("{}", value);
}
std::string text_of(glm::vec3 v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}
std::string text_of(const std::string& text) {
  return scenefile::quoted(text);
}
std::string text_of(const TextureUse& image) {
  return fmt::format("{} {} {} ({})", scenefile::quoted(image.file), image.repeat_u, image.repeat_v,
                     text_of(image.location));
}
template <typename Optional>
auto text_of(const Optional& value) -> decltype(text_of(*value)) {
  return value ? text_of(*value) : "none";
}

std::string text_of(const Transform& transform) {
  struct Of {
    std::string operator()(const Translate& t) { return "translate " + text_of(t.by); }
    std::string operator()(const Scale& s) { return "scale " + text_of(s.by); }
    std::string operator()(const Rotate& r) {
      return fmt::format("rotate {} angle {}", text_of(r.axis), r.angle_deg);
    }
    std::string operator()(const Matrix& matrix) {
      const glm::mat4 rows = glm::transpose(matrix.m());
      std::string text = "matrix";
      for (int r = 0; r < 4; ++r) {
        text += fmt::format("{} {} {}", r == 0 ? "" : " |", text_of(glm::vec3(rows[r])), rows[r].w);
      }
      return text;
    }
  };
  return text_of(transform.location) + " " + std::visit(Of{}, transform.map);
}

// Of several places for a value the last one counts, as for the value itself.
std::string place_of(const Scene& scene, Location owner, Field field) {
  std::string last;
  for (const FieldPlace& place : scene.field_places) {
    if (place.owner == owner && place.field == field) {
      last = fmt::format(" ({})", text_of(place.location));
    }
  }
  return last;
}

// `4:18 cube: shininess 20 (5:3), ior unread (5:24)`, of the members of `values`.
template <typename Values, std::size_t N>
std::string part(const Scene& scene, Location place, std::string_view what,
                 const ValueRow<Values> (&rows)[N], const Values& values, FieldSet unread) {
  std::vector<std::string> words;
  const auto add = [&](const ValueRow<Values>& row, auto member) {
    std::string text;
    if constexpr (!std::is_same_v<decltype(member), std::monostate>) {
      if (values.*member != Values{}.*member) {
        text += " " + text_of(values.*member);
      }
      if (row.field && unread.contains(*row.field)) {
        text += " unread";
      }
      if (row.field && !text.empty()) {
        text += place_of(scene, place, *row.field);
      }
    }
    if (!text.empty()) {
      words.push_back(std::string(row.name()) + text);
    }
  };
  for (const ValueRow<Values>& row : rows) {
    std::visit([&](auto member) { add(row, member); }, row.member);
  }
  return fmt::format("{} {}{}{}", text_of(place), what, words.empty() ? "" : ": ",
                     fmt::join(words, ", "));
}

// One line for a node with its transforms and objects, then one for each of its lights and nodes.
void add_node(std::string& lines, const Scene& scene, NodeId id, std::string_view node_word,
              std::size_t depth) {
  const Node& node = scene.nodes[id];
  lines += std::string(2 * depth, ' ') + text_of(node.location) + " ";
  lines += node_word;
  if (!node.name.empty()) {
    lines += " " + text_of(node.name.str());
  }
  if (!node.instance_of.empty()) {
    lines += fmt::format(" of {}{}", text_of(node.instance_of.str()),
                         place_of(scene, node.location, Field::instance_of));
  }
  for (const Transform& transform : node.transforms) {
    lines += "; " + text_of(transform);
  }
  for (const Primitive& p : node.primitives) {
    std::string what(word_of(p.shape));
    if (!p.mesh_file.empty()) {
      what += " " + text_of(p.mesh_file.str()) + place_of(scene, p.location, Field::mesh_file);
    }
    lines += "; " + part(scene, p.location, what, material_rows, p.material, p.unread);
  }
  lines += "\n";
  for (const Light& light : node.lights) {
    lines +=
        std::string(2 * depth + 2, ' ') +
        part(scene, light.location, light_type_name(light.type), light_rows, light, light.unread) +
        "\n";
  }
  for (const NodeId child : node.children) {
    const bool instance = !scene.nodes[child].instance_of.empty();
    add_node(lines, scene, child, instance ? "instance" : "group", depth + 1);
  }
}

std::string lines_of(const Scene& scene) {
  std::string lines = scene.name.empty() ? "" : "name " + text_of(scene.name) + "\n";
  if (scene.global.location.known() || !(scene.global == Global{})) {
    lines += part(scene, scene.global.location, "global", global_rows, scene.global,
                  scene.global.unread) +
             "\n";
  }
  if (scene.camera) {
    lines += part(scene, scene.camera->location, "camera", camera_rows, *scene.camera,
                  scene.camera->unread) +
             "\n";
  }
  for (const NodeId id : scene.templates) {
    add_node(lines, scene, id, "template", 0);
  }
  add_node(lines, scene, scene.root, scene.incomplete ? "incomplete root" : "root", 0);
  return lines;
}

std::string line_of(const Diagnostic& d) {
  std::string line = fmt::format("{} {}{} {}: {}", text_of(d.location),
                                 d.code->kind == CodeKind::dialect ? "dialect " : "",
                                 severity_text(d.severity), d.code->name, d.message);
  if (d.correction) {
    line += fmt::format(" {{{} -> {}{}}}", d.correction->written, d.correction->instead,
                        d.correction->certain ? "" : "?");
  }
  for (const std::string& note : d.notes) {
    line += "\n  " + note;
  }
  return line + "\n";
}

}  // namespace

std::string answer(std::string_view text, const ReadOptions& options, bool checked) {
  Reading reading = read(text, options);
  if (checked) {
    check(reading.scene, options.limits, reading.diagnostics);
  }
  std::string lines;
  for (const Diagnostic& d : reading.diagnostics.list()) {
    lines += line_of(d);
  }
  if (const std::size_t dropped = reading.diagnostics.dropped(); dropped > 0) {
    lines += fmt::format("and {} more\n", dropped);
  }
  return lines + lines_of(reading.scene);
}

}  // namespace scenefile::testing
