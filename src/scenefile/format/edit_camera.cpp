#include "scenefile/format/edit_camera.h"

#include "scenefile/base/number.h"
#include "scenefile/format/camera_slots.h"
#include "scenefile/format/syntax.h"
#include "scenefile/format/text_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace scenefile {

namespace {

struct Replacement {
  NumberSlot slot;
  std::string text;
};

/// Collects the changes to a text.
class CameraWriter {
 public:
  CameraWriter(std::string_view text, const CameraSlots& slots) : text_(text), slots_(slots) {}

  void number(const NumberSlot& slot, float value) {
    const ParsedNumber old = parse_number(text_.substr(slot.offset, slot.length));
    if (old.error != NumberError::none || static_cast<float>(old.value) != value) {
      edits_.push_back({slot, number_text(value)});
    }
  }

  void vector(const VectorSlots& slots, const glm::vec3& value) {
    for (int i = 0; i < 3; ++i) {
      number(slots[static_cast<std::size_t>(i)], value[i]);
    }
  }

  void add_element(std::string element) { added_ += slots_.indent + std::move(element); }

  /// Returns false if something must be added, but there is no place for it.
  bool apply(std::string& text) {
    if (!added_.empty()) {
      if (!slots_.end) {
        return false;
      }
      edits_.push_back({{*slots_.end, 0}, std::move(added_)});
    }
    std::sort(edits_.begin(), edits_.end(), [](const Replacement& a, const Replacement& b) {
      return a.slot.offset > b.slot.offset;
    });
    text = text_;
    for (const Replacement& edit : edits_) {
      text.replace(edit.slot.offset, edit.slot.length, edit.text);
    }
    return true;
  }

 private:
  std::string_view text_;
  const CameraSlots& slots_;
  std::vector<Replacement> edits_;
  std::string added_;
};

std::string vector_element(std::string_view name, const glm::vec3& value) {
  return fmt::format(R"(<{} x="{}" y="{}" z="{}"/>)", name, number_text(value.x),
                     number_text(value.y), number_text(value.z));
}

std::string angle_element(float value) {
  return fmt::format(R"(<heightangle v="{}"/>)", number_text(value));
}

std::string camera_element(const Camera& camera, const std::string& indent) {
  const std::string inner = indent.empty() ? "" : indent + "  ";
  return "<cameradata>" + inner + vector_element("pos", camera.position) + inner +
         vector_element("look", camera.look) + inner + vector_element("up", camera.up) + inner +
         angle_element(camera.height_angle_deg) + indent + "</cameradata>";
}

// Whether two directions are equal up to the float precision of distant points.
bool same_direction(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::normalize(glm::dvec3(a)) - glm::normalize(glm::dvec3(b))) < 1e-4;
}

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.up == b.up && a.height_angle_deg == b.height_angle_deg &&
         same_direction(a.look, b.look);
}

void write_camera(const Camera& before, const Camera& camera, const CameraSlots& slots,
                  CameraWriter& writer) {
  if (slots.position) {
    writer.vector(*slots.position, camera.position);
  } else if (camera.position != before.position) {
    writer.add_element(vector_element("pos", camera.position));
  }
  if (slots.focus) {
    writer.vector(*slots.focus, camera.position + camera.look);
  }
  if (slots.look) {
    writer.vector(*slots.look, camera.look);
  } else if (!slots.focus && camera.look != before.look) {
    writer.add_element(vector_element("look", camera.look));
  }
  if (slots.up) {
    writer.vector(*slots.up, camera.up);
  } else if (camera.up != before.up) {
    writer.add_element(vector_element("up", camera.up));
  }
  if (slots.height_angle) {
    writer.number(*slots.height_angle, camera.height_angle_deg);
  } else if (camera.height_angle_deg != before.height_angle_deg) {
    writer.add_element(angle_element(camera.height_angle_deg));
  }
}

CameraEdit refuse(std::string why) {
  return {{}, std::move(why)};
}

// Whether the edited bytes are the same scene with the new camera.
bool is_as_wanted(std::string_view bytes, Scene before, const Camera& camera,
                  const ReadOptions& options) {
  Diagnostics found;
  Scene after = read_scene(bytes, options, found);
  if (found.has_errors() || !after.camera || !same_camera(*after.camera, camera)) {
    return false;
  }
  after.camera.reset();
  before.camera.reset();
  return after == before;
}

}  // namespace

CameraEdit edit_camera(std::string_view bytes, const Camera& camera, const ReadOptions& options) {
  Diagnostics found;
  std::string storage;
  const Scene before = read_scene(bytes, options, found);
  if (found.has_errors()) {
    return refuse("the file has errors; correct them first");
  }
  if (bytes.find('\0') != std::string_view::npos) {
    return refuse("the file is in UTF-16; save it as UTF-8 first");
  }
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const std::string_view text = bytes.substr(bytes.starts_with(mark) ? mark.size() : 0);
  const bool json = syntax_of(text, found) == SceneFormat::json;
  const CameraSlots slots = json ? json_camera_slots(text) : xml_camera_slots(text);
  if (json && !slots.position) {
    return refuse(
        "the file has numbers that are not valid JSON, such as .5 or 1.; correct them first");
  }
  CameraWriter writer(text, slots);
  if (slots.missing) {
    writer.add_element(camera_element(camera, slots.indent));
  } else {
    write_camera(before.camera.value_or(Camera{}), camera, slots, writer);
  }
  std::string edited;
  if (!writer.apply(edited)) {
    return refuse(
        slots.missing
            ? "the file has no <cameradata>, and no <globaldata> after which one could be inserted"
            : "the camera of the file lacks values that the view needs");
  }
  edited.insert(0, bytes.substr(0, bytes.size() - text.size()));
  if (!is_as_wanted(edited, before, camera, options)) {
    return refuse(
        "the camera of this file cannot be changed without changing more; "
        "\"scenefile convert\" writes it cleanly");
  }
  return {std::move(edited), {}};
}

}  // namespace scenefile
