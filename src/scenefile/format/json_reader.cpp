#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/dialects.h"
#include "scenefile/format/json_blocks.h"
#include "scenefile/format/json_fields.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_syntax.h"
#include "scenefile/format/reserve_nodes.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace scenefile {

namespace {

namespace root {
enum Key { global, camera, groups, name, templates };
constexpr std::string_view names[] = {"globalData", "cameraData", "groups", "name",
                                      "templateGroups"};
constexpr JsonVocabulary vocabulary{"the scene", names};
}  // namespace root

namespace group {
enum Key { name, translate, rotate, scale, matrix, lights, primitives, groups };
static_assert(lights - translate == transform_words.size());
constexpr std::string_view names[] = {"name",
                                      transform_word<Translate>,
                                      transform_word<Rotate>,
                                      transform_word<Scale>,
                                      transform_word<Matrix>,
                                      "lights",
                                      "primitives",
                                      "groups"};
constexpr JsonVocabulary vocabulary{"a group", names};
constexpr JsonVocabulary template_vocabulary{"a template group", names};
}  // namespace group

class SceneReader {
 public:
  SceneReader(const JsonTape& tape, std::string_view text, const RepairedJson& repaired,
              const Limits& limits, Diagnostics& diagnostics)
      : context_(tape, text, repaired, limits, diagnostics) {}

  Scene read() {
    if (!tape().is_object(0)) {
      context_.report("json.wrong-type"_code, 0,
                      "a scene must be an object, found " + describe_json(tape(), 0));
      return {};
    }
    const JsonFields fields(context_, 0, root::vocabulary);
    if (fields.require(root::global)) {
      read_json_global(context_, fields.key(root::global), scene_);
    }
    if (fields.require(root::camera)) {
      read_json_camera(context_, fields.key(root::camera), scene_);
    }
    if (fields.has(root::name)) {
      scene_.name = text_value(context_, fields.key(root::name), limits().name_bytes).value_or("");
    }
    scene_.nodes[scene_.root].location = context_.place(0);
    read_templates(fields);
    read_root_groups(fields);
    return std::move(scene_);
  }

 private:
  // The remaining groups of an array.
  struct Frame {
    JsonIndex next;
    JsonIndex end;
    NodeId parent;
  };

  const JsonTape& tape() const { return context_.tape; }
  const Limits& limits() const { return context_.limits; }
  double progress(JsonIndex item) const {
    return static_cast<double>(item) / static_cast<double>(tape().items.size());
  }

  void read_root_groups(const JsonFields& fields) {
    if (!fields.has(root::groups)) {
      context_.report("json.no-groups"_code, 0,
                      "the scene has no key \"groups\", so there is nothing in it");
      return;
    }
    push_groups(fields.key(root::groups), scene_.root);
    read_frames();
  }

  void read_templates(const JsonFields& fields) {
    if (!fields.has(root::templates) ||
        !is_json_list(context_, fields.key(root::templates), "template groups")) {
      return;
    }
    const JsonIndex list = fields.key(root::templates) + 1;
    known_templates_ = 0;
    collect_template_names(list);
    for (JsonIndex item = list + 1; item < tape().end(list); item = tape().end(item)) {
      read_template(item);
      ++known_templates_;
    }
    known_templates_ = std::numeric_limits<std::size_t>::max();
  }

  // Collects all names first, to detect templates that are declared later.
  void collect_template_names(JsonIndex list) {
    std::size_t place = 0;
    for (JsonIndex item = list + 1; item < tape().end(list); item = tape().end(item), ++place) {
      if (!tape().is_object(item)) {
        continue;
      }
      bool named = false;
      for (JsonIndex key = item + 1; key < tape().end(item); key = tape().end(key + 1)) {
        if (tape().raw(key) == "name" && tape().is_string(key + 1)) {
          templates_.try_emplace(tape().string(key + 1), place);
          named = true;
        }
      }
      lost_template_ = lost_template_ || !named;
    }
  }

  void read_template(JsonIndex item) {
    if (!is_group(item, "a template group")) {
      return;
    }
    const JsonFields fields(context_, item, group::template_vocabulary);
    std::optional<std::string> name = "";
    if (fields.has(group::name)) {
      name = text_value(context_, fields.key(group::name), limits().name_bytes);
    }
    if (name && !name->empty()) {  // also one whose key is misspelled
      templates_.try_emplace(*name, known_templates_);
    }
    const NodeId node = add_template(scene_, name.value_or(""));
    if (!name) {
      scene_.templates.pop_back();  // not a template without a name: the name was reported
    }
    scene_.nodes[node].location = context_.place(item);
    read_contents(node, fields);
    read_frames();
  }

  void read_frames() {
    while (!frames_.empty()) {
      Frame& top = frames_.back();
      if (top.next >= top.end) {
        frames_.pop_back();
        continue;
      }
      const JsonIndex item = top.next;
      top.next = tape().end(item);
      read_group(item, top.parent);
    }
  }

  bool is_group(JsonIndex item, std::string_view what) {
    if (tape().is_object(item)) {
      return true;
    }
    context_.report("json.wrong-type"_code, item,
                    fmt::format("{} (an element of \"groups\" or \"templateGroups\") must be an "
                                "object, found {}",
                                what, describe_json(tape(), item)));
    return false;
  }

  void push_groups(JsonIndex key, NodeId parent) {
    if (is_json_list(context_, key, "groups")) {
      frames_.push_back({key + 2, tape().end(key + 1), parent});
    }
  }

  void read_group(JsonIndex item, NodeId parent) {
    if (!is_group(item, "a group")) {
      return;
    }
    const JsonFields fields(context_, item, group::vocabulary);
    reserve_nodes(scene_.nodes, progress(item));
    const NodeId node = add_child(scene_, parent);
    scene_.nodes[node].location = context_.place(item);
    if (fields.has(group::name)) {
      std::optional<std::string> name =
          text_value(context_, fields.key(group::name), limits().name_bytes);
      if (name && read_as_instance(node, fields, *name)) {
        return;
      }
      scene_.nodes[node].name = std::move(name).value_or("");
    }
    read_contents(node, fields);
  }

  static bool has_contents(const JsonFields& fields) {
    return fields.has(group::lights) || fields.has(group::primitives) ||
           fields.has(group::groups) || fields.unknown() != 0;
  }

  // A group with the name of a template declared before is an instance of it. A group with the name
  // of a later template is an instance only if it is otherwise empty.
  bool read_as_instance(NodeId node, const JsonFields& fields, const std::string& name) {
    const auto found = templates_.find(name);
    if (found == templates_.end()) {
      if (!has_contents(fields) && !lost_template_) {
        report_unknown_template(fields.key(group::name), name);
      }
      return false;
    }
    if (found->second >= known_templates_ && has_contents(fields)) {
      context_.report("json.template-order"_code, fields.key(group::name),
                      fmt::format("group {} has the name of a template that is declared later; it "
                                  "is read as a separate group",
                                  quoted(name)));
      return false;
    }
    report_ignored_keys(fields, name);
    scene_.nodes[node].instance_of = name;
    scene_.field_places.push_back(
        {scene_.nodes[node].location, Field::instance_of, context_.place(fields.key(group::name))});
    return true;
  }

  void report_unknown_template(JsonIndex key, const std::string& name) {
    std::vector<std::string_view> known;
    constexpr std::size_t enough = 1000;
    for (const auto& [known_name, place] : templates_) {
      if (known.size() < enough) {
        known.push_back(known_name);
      }
    }
    std::sort(known.begin(), known.end());
    const std::string_view near = nearest_name(name, known);
    context_.report(
        "json.unknown-template"_code, key,
        fmt::format("group {} is empty, and no template group has this name{}", quoted(name),
                    near.empty() ? "" : fmt::format("; did you mean {}?", quoted(near))),
        correction(name, near, known));
  }

  void report_ignored_keys(const JsonFields& fields, const std::string& name) {
    std::vector<std::string_view> ignored;
    JsonIndex first = 0;
    for (std::size_t key = group::name + 1; key < std::size(group::names); ++key) {
      if (fields.has(key)) {
        first = ignored.empty() ? fields.key(key) : std::min(first, fields.key(key));
        ignored.push_back(group::names[key]);
      }
    }
    if (!ignored.empty()) {
      context_.report(
          "json.instance-keys"_code, first,
          fmt::format("group {} is an instance of the template of that name; its {} "
                      "{} ignored",
                      quoted(name), fmt::join(ignored, ", "), ignored.size() == 1 ? "is" : "are"));
    }
  }

  void read_contents(NodeId id, const JsonFields& fields) {
    Node& node = scene_.nodes[id];
    read_transforms(node, fields);
    if (fields.has(group::lights)) {
      read_list(fields.key(group::lights), "lights", node.lights, read_json_light);
    }
    if (fields.has(group::primitives)) {
      read_list(fields.key(group::primitives), "primitives", node.primitives, read_json_primitive);
    }
    if (fields.has(group::groups)) {
      push_groups(fields.key(group::groups), id);
    }
  }

  template <typename Part, typename Read>
  void read_list(JsonIndex key, std::string_view what, std::vector<Part>& parts, Read read_part) {
    if (!is_json_list(context_, key, what)) {
      return;
    }
    for (JsonIndex item = key + 2; item < tape().end(key + 1); item = tape().end(item)) {
      if (std::optional<Part> part = read_part(context_, item, scene_)) {
        parts.push_back(*std::move(part));
      }
    }
  }

  // Always in this order, regardless of the order of the keys.
  void read_transforms(Node& node, const JsonFields& fields) {
    using group::matrix, group::rotate, group::scale, group::translate;
    const bool others = fields.has(translate) || fields.has(rotate) || fields.has(scale);
    node.transforms.reserve(static_cast<std::size_t>(fields.has(translate)) + fields.has(rotate) +
                            fields.has(scale) + fields.has(matrix));
    const auto add = [&](std::size_t key, const auto& map) {
      node.transforms.push_back({map, context_.place(fields.key(key))});
    };
    if (fields.has(translate)) {
      add(translate,
          Translate{vector_value(context_, fields.key(translate)).value_or(glm::vec3(0))});
    }
    if (fields.has(rotate)) {
      const glm::vec4 r =
          rotation_value(context_, fields.key(rotate)).value_or(glm::vec4(0, 1, 0, 0));
      add(rotate, Rotate{glm::vec3(r), r.w});
    }
    if (fields.has(scale)) {
      add(scale, Scale{vector_value(context_, fields.key(scale)).value_or(glm::vec3(1))});
    }
    if (fields.has(matrix)) {
      add(matrix, Matrix{matrix_value(context_, fields.key(matrix)).value_or(glm::mat4(1))});
      if (others) {
        context_.report("json.matrix-with-others"_code, fields.key(matrix),
                        "\"matrix\" acts first, before scale, rotate and translate");
      }
    }
  }

  JsonContext context_;
  Scene scene_;
  std::vector<Frame> frames_;
  std::unordered_map<std::string, std::size_t> templates_;  // by name: index in templateGroups
  bool lost_template_ = false;       // a template whose name could not be read, which may be used
  std::size_t known_templates_ = 0;  // the number of templates that can be instantiated so far
};

bool fits(std::string_view text, const Limits& limits, Diagnostics& diagnostics) {
  const std::uint64_t most =
      std::min<std::uint64_t>(limits.file_bytes, std::numeric_limits<std::uint32_t>::max());
  if (text.size() <= most) {
    return true;
  }
  diagnostics.report(
      "json.limit"_code, {},
      fmt::format("the text has {} bytes, more than the limit of {}", text.size(), most));
  return false;
}

}  // namespace

Scene read_json(std::string_view text, const ReadOptions& options, Diagnostics& diagnostics) {
  if (!fits(text, options.limits, diagnostics)) {
    return {};
  }
  JsonTape tape;
  RepairedJson repaired;
  JsonError error = parse_json(text, options.limits.nesting, tape);
  if (error.fault != JsonFault::none && options.compat_course) {
    repaired = repair_json_numbers(text, diagnostics);
    error = parse_json(repaired.text, options.limits.nesting, tape);
  }
  if (error.fault != JsonFault::none &&
      !recover_json(std::move(error), text, options.limits, repaired, tape, diagnostics)) {
    return {};
  }
  return SceneReader(tape, text, repaired, options.limits, diagnostics).read();
}

}  // namespace scenefile
