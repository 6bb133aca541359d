#include "scenefile/verbs/compare_scenes.h"

#include "scenefile/base/text.h"
#include "scenefile/verbs/scene_json.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

// "chess.xml:41:9: ", or empty.
std::string place_text(const std::string& path, Location location) {
  return location.known() ? fmt::format("{}:{}:{}: ", escaped(shown_name(path), 4096),
                                        location.line, location.column)
                          : std::string();
}

std::string verdict_text(const std::string& a, const std::string& b, const SceneDiff& diff) {
  const std::string both =
      fmt::format("{} and {}", escaped(shown_name(a), 4096), escaped(shown_name(b), 4096));
  const std::size_t count = diff.differences.size();
  if (diff.same_meaning) {
    return both + (diff.equal ? ": no difference\n" : ": same meaning, written differently\n");
  }
  return fmt::format("{}: {} difference{}\n", both, count, count == 1 ? "" : "s");
}

// One scene's side of a difference; omitted if the object does not exist in the scene.
void add_side(Json& json, std::string_view name, const std::string& text, Location location) {
  if (text.empty()) {
    return;
  }
  json.begin_object(name);
  json.add("text", text);
  add_location(json, location);
  json.end_object();
}

}  // namespace

SceneDiff compare_scenes(const LoadedScene& a, const LoadedScene& b) {
  return diff_meaning(a.written, b.written);
}

std::string compare_scenes_text(const LoadedScene& a, const LoadedScene& b, const SceneDiff& diff) {
  std::string text;
  for (const SceneDifference& difference : diff.differences) {
    text += place_text(a.path, difference.in_a) + place_text(b.path, difference.in_b) +
            difference_text(difference) + "\n";
  }
  return text + verdict_text(a.path, b.path, diff);
}

std::string compare_scenes_json(const LoadedScene& a, const LoadedScene& b, const SceneDiff* diff) {
  Json json;
  begin_document(json, "diff");
  json.key("a");
  add_scene(json, a);
  json.key("b");
  add_scene(json, b);
  if (diff != nullptr) {
    json.add("equal", diff->equal);
    json.add("same_meaning", diff->same_meaning);
    json.begin_array("differences");
    for (const SceneDifference& difference : diff->differences) {
      json.begin_object();
      json.add("where", difference.where);
      add_side(json, "a", difference.a, difference.in_a);
      add_side(json, "b", difference.b, difference.in_b);
      json.end_object();
    }
    json.end_array();
  }
  json.end_object();
  return json.text();
}

}  // namespace scenefile
