#include "scenefile/format/edit_camera.h"

#include "scenefile/base/number.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/scene_text.h"
#include "scenefile/format/xml_scanner.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace scenefile {

namespace {

// The numbers of a vector where they are written in the text.
using WrittenVector = std::array<std::string_view, 3>;

// The values that a file gives for its camera; nullopt for those it does not give.
struct WrittenCamera {
  std::optional<WrittenVector> position;
  std::optional<WrittenVector> look;
  std::optional<WrittenVector> focus;
  std::optional<WrittenVector> up;
  std::optional<std::string_view> height_angle;

  // Where an element can be added to the camera (XML only), and the line end and indentation to
  // put before it.
  std::optional<std::size_t> end;
  std::string indent;
  // The file has no camera: one can be added at `end`, after the element indented by `indent`.
  bool missing = false;
};

constexpr const ValueRow<Camera>& position_row = row_of(camera_rows, Field::position);
constexpr const ValueRow<Camera>& look_row = row_of(camera_rows, Field::look);
constexpr const ValueRow<Camera>& up_row = row_of(camera_rows, Field::up);
constexpr const ValueRow<Camera>& angle_row = row_of(camera_rows, Field::height_angle_deg);
constexpr std::string_view focus_name = "focus";  // in both dialects

// By name, or by order if there are three attributes with other names, like the reader does.
std::optional<WrittenVector> vector_in(std::span<const XmlAttribute> attributes) {
  constexpr std::string_view names[] = {"x", "y", "z"};
  WrittenVector vector;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const XmlAttribute& attribute : attributes) {
      if (attribute.name == names[i]) {
        vector[i] = attribute.value;
        ++found;
      }
    }
  }
  if (found == 0 && attributes.size() == 3) {
    return WrittenVector{attributes[0].value, attributes[1].value, attributes[2].value};
  }
  return found == 3 ? std::optional(vector) : std::nullopt;
}

std::optional<std::string_view> number_in(std::span<const XmlAttribute> attributes) {
  for (const std::string_view name : {"v", "value", "val", "n"}) {
    for (const XmlAttribute& attribute : attributes) {
      if (attribute.name == name) {
        return attribute.value;
      }
    }
  }
  return attributes.size() == 1 ? std::optional(attributes.front().value) : std::nullopt;
}

void take_part(const XmlToken& tag, WrittenCamera& camera) {
  if (tag.name == position_row.xml) {
    camera.position = vector_in(tag.attributes);
  } else if (tag.name == look_row.xml) {
    camera.look = vector_in(tag.attributes);
  } else if (tag.name == focus_name) {
    camera.focus = vector_in(tag.attributes);
  } else if (tag.name == up_row.xml) {
    camera.up = vector_in(tag.attributes);
  } else if (tag.name == angle_row.xml || tag.name == angle_row.xml_alias) {
    camera.height_angle = number_in(tag.attributes);
  }
}

// The line end and the white space before a tag; empty if the tag is not the first thing on its
// line.
std::string indent_before(std::string_view text, std::size_t offset) {
  std::size_t begin = offset;
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) {
    --begin;
  }
  if (begin == 0 || text[begin - 1] != '\n') {
    return {};
  }
  --begin;
  begin -= begin > 0 && text[begin - 1] == '\r' ? 1 : 0;
  return std::string(text.substr(begin, offset - begin));
}

// Walks the tokens of a file and keeps its last camera.
class CameraSearch {
 public:
  explicit CameraSearch(std::string_view text) : text_(text) { globals_.missing = true; }

  void take(const XmlToken& token) {
    const bool opens = token.kind == XmlTokenKind::start || token.kind == XmlTokenKind::empty;
    if (opens) {
      open(token);
    }
    depth_ += token.kind == XmlTokenKind::start ? 1 : 0;
    depth_ -= token.kind == XmlTokenKind::end ? 1 : 0;
    if (token.kind == XmlTokenKind::end || token.kind == XmlTokenKind::empty) {
      close(token);
    }
  }

  WrittenCamera result() const { return found_ ? camera_ : globals_; }

 private:
  void open(const XmlToken& token) {
    if (depth_ == 1) {
      block_ = token.name;
      block_indent_ = indent_before(text_, begin_of(token));
      if (block_ == "cameradata") {
        found_ = true;
        camera_ = {};
        camera_.indent = block_indent_.empty() ? "" : block_indent_ + "  ";
        if (token.kind == XmlTokenKind::start) {
          camera_.end = begin_of(token) + token.written.size();
        }
      }
    } else if (depth_ == 2 && block_ == "cameradata") {
      take_part(token, camera_);
      camera_.indent = indent_before(text_, begin_of(token));
    }
  }

  // Called after the end of an element; depth_ is that of its siblings.
  void close(const XmlToken& token) {
    if (depth_ == 1 && block_ == "globaldata") {
      globals_.end = begin_of(token) + token.written.size();
      globals_.indent = block_indent_;
    } else if (depth_ == 2 && block_ == "cameradata") {
      camera_.end = begin_of(token) + token.written.size();
    }
  }

  std::size_t begin_of(const XmlToken& token) const {
    return static_cast<std::size_t>(token.written.data() - text_.data());
  }

  std::string_view text_;
  std::size_t depth_ = 0;
  std::string_view block_;
  std::string block_indent_;
  bool found_ = false;
  WrittenCamera camera_;
  WrittenCamera globals_;
};

// The value of the last member with that name; 0 if there is none.
JsonIndex member(const JsonTape& tape, JsonIndex object, std::string_view name) {
  JsonIndex found = 0;
  if (!tape.is_object(object)) {
    return found;
  }
  for (JsonIndex key = object + 1; key < tape.end(object); key = tape.end(key + 1)) {
    if (tape.string(key) == name) {
      found = key + 1;
    }
  }
  return found;
}

std::optional<std::string_view> number_in_json(const JsonTape& tape, JsonIndex value) {
  if (value == 0 || !tape.is_number(value)) {
    return std::nullopt;
  }
  return tape.raw(value);
}

std::optional<WrittenVector> vector_in_json(const JsonTape& tape, JsonIndex value) {
  if (value == 0 || !tape.is_array(value) || tape.items[value].extent != 3) {
    return std::nullopt;
  }
  WrittenVector vector;
  for (JsonIndex i = 0; i < 3; ++i) {
    const std::optional<std::string_view> number = number_in_json(tape, value + 1 + i);
    if (!number) {
      return std::nullopt;
    }
    vector[i] = *number;
  }
  return vector;
}

// Requires a text that read_scene() accepts, in UTF-8 or another superset of ASCII, without a byte
// order mark.
WrittenCamera find_xml_camera(std::string_view text) {
  CameraSearch search(text);
  XmlScanner scanner(text);
  for (XmlToken token; scanner.next(token);) {
    search.take(token);
  }
  return search.result();
}

// Same for strict JSON; finds nothing where numbers were repaired.
WrittenCamera find_json_camera(std::string_view text) {
  WrittenCamera written;
  JsonTape tape;
  constexpr std::uint32_t deep = 1 << 20;  // read_scene() has checked the real limit
  if (parse_json(text, deep, tape).fault != JsonFault::none) {
    return written;
  }
  const JsonIndex camera = member(tape, 0, "cameraData");
  if (camera == 0) {
    return written;
  }
  written.position = vector_in_json(tape, member(tape, camera, position_row.json));
  written.look = vector_in_json(tape, member(tape, camera, look_row.json));
  written.focus = vector_in_json(tape, member(tape, camera, focus_name));
  written.up = vector_in_json(tape, member(tape, camera, up_row.json));
  written.height_angle = number_in_json(tape, member(tape, camera, angle_row.json));
  return written;
}

struct Replacement {
  std::string_view old;  // in the text
  std::string text;
};

// Collects the changes to a text.
class CameraWriter {
 public:
  CameraWriter(std::string_view text, const WrittenCamera& written)
      : text_(text), written_(written) {}

  void number(std::string_view written, float value) {
    const ParsedNumber old = parse_number(written);
    if (old.error != NumberError::none || static_cast<float>(old.value) != value) {
      edits_.push_back({written, number_text(value)});
    }
  }

  void vector(const WrittenVector& written, const glm::vec3& value) {
    for (int i = 0; i < 3; ++i) {
      number(written[static_cast<std::size_t>(i)], value[i]);
    }
  }

  void add_element(std::string element) { added_ += written_.indent + std::move(element); }

  /// Returns false if something must be added, but there is no place for it.
  bool apply(std::string& text) {
    if (!added_.empty()) {
      if (!written_.end) {
        return false;
      }
      edits_.push_back({text_.substr(*written_.end, 0), std::move(added_)});
    }
    std::sort(edits_.begin(), edits_.end(), [](const Replacement& a, const Replacement& b) {
      return a.old.data() > b.old.data();
    });
    text = text_;
    for (const Replacement& edit : edits_) {
      text.replace(static_cast<std::size_t>(edit.old.data() - text_.data()), edit.old.size(),
                   edit.text);
    }
    return true;
  }

 private:
  std::string_view text_;
  const WrittenCamera& written_;
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

void write_camera(const Camera& before, const Camera& camera, const WrittenCamera& written,
                  CameraWriter& writer) {
  if (written.position) {
    writer.vector(*written.position, camera.position);
  } else if (camera.position != before.position) {
    writer.add_element(vector_element("pos", camera.position));
  }
  if (written.focus) {
    writer.vector(*written.focus, camera.position + camera.look);
  }
  if (written.look) {
    writer.vector(*written.look, camera.look);
  } else if (!written.focus && camera.look != before.look) {
    writer.add_element(vector_element("look", camera.look));
  }
  if (written.up) {
    writer.vector(*written.up, camera.up);
  } else if (camera.up != before.up) {
    writer.add_element(vector_element("up", camera.up));
  }
  if (written.height_angle) {
    writer.number(*written.height_angle, camera.height_angle_deg);
  } else if (camera.height_angle_deg != before.height_angle_deg) {
    writer.add_element(angle_element(camera.height_angle_deg));
  }
}

Error refuse(std::string why) {
  return {std::move(why), ErrorKind::input};
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

Result<std::string> edit_camera(std::string_view bytes, const Camera& camera,
                                const ReadOptions& options) {
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
  const std::optional<SceneText> file = open_text(bytes, storage, found);
  const bool json = file && file->syntax == SceneFormat::json;
  const WrittenCamera written = json ? find_json_camera(text) : find_xml_camera(text);
  if (json && !written.position) {
    return refuse(
        "the file has numbers that are not valid JSON, such as .5 or 1.; correct them first");
  }
  CameraWriter writer(text, written);
  if (written.missing) {
    writer.add_element(camera_element(camera, written.indent));
  } else {
    write_camera(before.camera.value_or(Camera{}), camera, written, writer);
  }
  std::string edited;
  if (!writer.apply(edited)) {
    return refuse(
        written.missing
            ? "the file has no <cameradata>, and no <globaldata> after which one could be inserted"
            : "the camera of the file is missing values that the view needs");
  }
  edited.insert(0, bytes.substr(0, bytes.size() - text.size()));
  if (!is_as_wanted(edited, before, camera, options)) {
    return refuse(
        "the camera of this file cannot be changed without changing more; "
        "\"scenefile convert\" writes it cleanly");
  }
  return edited;
}

}  // namespace scenefile
