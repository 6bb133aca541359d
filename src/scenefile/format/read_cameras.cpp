#include "scenefile/format/read_cameras.h"

#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/text_places.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <variant>

namespace scenefile {

namespace {

constexpr std::size_t max_views = 100000;
constexpr double max_seconds = 1e6;
constexpr double max_fps = 1000;

constexpr std::string_view look_name = row_of(camera_rows, Field::look).json;
constexpr std::string_view focus_key = "focus";

std::vector<std::string_view> view_words() {
  std::vector<std::string_view> words{"time"};
  for (const ValueRow<Camera>& row : camera_rows) {
    if (!row.json.empty()) {
      words.push_back(row.json);
    }
  }
  return words;
}

// The value as JSON; empty for a row without one.
std::string value_text(const Camera& camera, const ValueRow<Camera>& row) {
  if (const auto* const number = std::get_if<float Camera::*>(&row.member)) {
    return fmt::format("{}", camera.**number);
  }
  if (const auto* const vector = std::get_if<glm::vec3 Camera::*>(&row.member)) {
    const glm::vec3& v = camera.**vector;
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
  }
  return {};
}

class CameraReader {
 public:
  CameraReader(std::string_view text, const Camera& camera, const Limits& limits)
      : text_(without_byte_order_mark(text)), limits_(limits), camera_(camera) {}

  Result<CameraPath> read() {
    const JsonError fault = parse_json(text_, limits_.nesting, tape_);
    if (fault.fault != JsonFault::none) {
      return error_at(fault.offset, "the text is not JSON from here on");
    }
    if (!tape_.is_object(0) || !has_views()) {
      return error(0, "expected an object with the key \"views\"");
    }
    const bool good = for_each_member(0, [&](const std::string& key, JsonIndex k, JsonIndex value) {
      if (key == "fps") {
        double fps = 0;
        const bool read = number(value, 1e-3, max_fps, fps);
        path_.fps = fps;
        return read;
      }
      return key == "views" ? views(value) : unknown(k, key, {"fps", "views"});
    });
    if (!good) {
      return error_;
    }
    if (path_.views.empty()) {
      return error(0, "there are no views");
    }
    return std::move(path_);
  }

 private:
  // Messages quote other keys only if this is true; otherwise the file does not describe cameras.
  bool has_views() const {
    JsonIndex key = 1;
    while (key < tape_.end(0) && tape_.string(key) != "views") {
      key = tape_.end(key + 1);
    }
    return key < tape_.end(0);
  }

  Error error_at(std::size_t offset, std::string_view what) {
    const Location place = TextPlaces(text_).at(offset);
    return {fmt::format("{}:{}: {}", place.line, place.column, what), ErrorKind::input};
  }
  Error error(JsonIndex item, std::string_view what) {
    return error_at(tape_.items[item].offset, what);
  }
  bool fail(JsonIndex item, std::string_view what) {
    error_ = error(item, what);
    return false;
  }
  bool unknown(JsonIndex key, const std::string& found,
               const std::vector<std::string_view>& known) {
    const std::string_view near = nearest_name(found, known);
    return fail(
        key, near.empty()
                 ? fmt::format("unknown key {}; known: {}", quoted(found), fmt::join(known, ", "))
                 : fmt::format("unknown key {}; did you mean {}?", quoted(found), quoted(near)));
  }

  bool for_each_member(
      JsonIndex object,
      const std::function<bool(const std::string&, JsonIndex, JsonIndex)>& member) {
    for (JsonIndex key = object + 1; key < tape_.end(object); key = tape_.end(key + 1)) {
      if (!member(tape_.string(key), key, key + 1)) {
        return false;
      }
    }
    return true;
  }

  bool number(JsonIndex item, double least, double most, double& value) {
    const ParsedNumber parsed =
        tape_.is_number(item) ? parse_number(tape_.raw(item)) : ParsedNumber{};
    value = parsed.value;
    if (!tape_.is_number(item) || parsed.error != NumberError::none || value < least ||
        value > most) {
      return fail(item, fmt::format("expected a number from {:g} to {:g}", least, most));
    }
    return true;
  }

  bool vector(JsonIndex item, glm::vec3& value) {
    int count = 0;
    if (tape_.is_array(item)) {
      for (JsonIndex i = item + 1; i < tape_.end(item) && count < 4; i = tape_.end(i), ++count) {
        double x = 0;
        if (!number(i, -1e30, 1e30, x)) {
          return false;
        }
        if (count < 3) {
          value[count] = static_cast<float>(x);
        }
      }
    }
    return count == 3 || fail(item, "expected three numbers such as [0, 1, 0]");
  }

  bool views(JsonIndex array) {
    if (!tape_.is_array(array)) {
      return fail(array, "expected a list of views");
    }
    for (JsonIndex item = array + 1; item < tape_.end(array); item = tape_.end(item)) {
      if (path_.views.size() == max_views) {
        return fail(item, fmt::format("there are more than {} views", max_views));
      }
      if (!tape_.is_object(item)) {
        return fail(item, "expected a view, an object");
      }
      if (!view(item)) {
        return false;
      }
    }
    return true;
  }

  bool view(JsonIndex item) {
    const bool first = path_.views.empty();
    CameraView view = first ? CameraView{0, camera_, {}} : path_.views.back();
    const double before = view.time;
    view.time += first ? 0 : 1;
    bool has_look = false;
    bool has_focus = false;
    const bool good = for_each_member(item, [&](const std::string& key, JsonIndex k, JsonIndex v) {
      if (key == "time") {
        return number(v, 0, max_seconds, view.time);
      }
      if (key == focus_key) {
        has_focus = true;
        return vector(v, view.focus.emplace());
      }
      has_look = has_look || key == look_name;
      for (const ValueRow<Camera>& row : camera_rows) {
        if (key != row.json) {
          continue;
        }
        if (const auto* const member = std::get_if<float Camera::*>(&row.member)) {
          double x = 0;
          const bool read = number(v, 0, 1e30, x);
          view.camera.** member = static_cast<float>(x);
          return read;
        }
        if (const auto* const member = std::get_if<glm::vec3 Camera::*>(&row.member)) {
          return vector(v, view.camera.**member);
        }
      }
      return unknown(k, key, view_words());
    });
    if (!good) {
      return false;
    }
    if (has_look && has_focus) {
      return fail(item, "a view has either look, a direction, or focus, a point");
    }
    if (has_look) {
      view.focus.reset();
    }
    if (view.focus) {
      view.camera.look = *view.focus - view.camera.position;
    }
    if (!first && view.time <= before) {
      return fail(item, fmt::format("the time {} is not after that of the view before, {}",
                                    view.time, before));
    }
    path_.views.push_back(view);
    return true;
  }

  std::string_view text_;
  const Limits& limits_;
  Camera camera_;
  JsonTape tape_;
  CameraPath path_;
  Error error_;
};

}  // namespace

Result<CameraPath> read_cameras(std::string_view text, const Camera& camera, const Limits& limits) {
  return CameraReader(text, camera, limits).read();
}

std::string write_cameras(const CameraPath& path) {
  std::string text = "{\n";
  if (path.fps) {
    text += fmt::format("  \"fps\": {},\n", *path.fps);
  }
  text += "  \"views\": [\n";
  for (const CameraView& view : path.views) {
    text += fmt::format("    {{\"time\": {}", view.time);
    for (const ValueRow<Camera>& row : camera_rows) {
      Camera camera = view.camera;
      camera.look = view.focus.value_or(camera.look);
      const std::string value = value_text(camera, row);
      if (!value.empty()) {
        text += fmt::format(", \"{}\": {}",
                            row.json == look_name && view.focus ? focus_key : row.json, value);
      }
    }
    text += &view == &path.views.back() ? "}\n" : "},\n";
  }
  return text + "  ]\n}\n";
}

}  // namespace scenefile
