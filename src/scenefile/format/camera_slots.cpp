#include "scenefile/format/camera_slots.h"

#include "scenefile/format/json_parser.h"
#include "scenefile/format/xml_tag.h"
#include "scenefile/format/xml_tokens.h"
#include "scenefile/scene/vocabulary.h"

#include <algorithm>
#include <span>
#include <vector>

namespace scenefile {

namespace {

/// An attribute of a tag; the value without its quotes.
struct Attribute {
  std::string_view name;
  NumberSlot value;
};

struct Tag {
  std::string_view name;
  std::vector<Attribute> attributes;
};

Tag tag_of(std::string_view text, const XmlToken& token) {
  std::vector<XmlAttribute> written;
  Tag tag{scan_tag(token.of(text), written).name, {}};
  for (const XmlAttribute& attribute : written) {
    const auto offset = static_cast<std::size_t>(attribute.value.data() - text.data());
    tag.attributes.push_back({attribute.name, {offset, attribute.value.size()}});
  }
  return tag;
}

constexpr const ValueRow<Camera>& position_row = row_of(camera_rows, Field::position);
constexpr const ValueRow<Camera>& look_row = row_of(camera_rows, Field::look);
constexpr const ValueRow<Camera>& up_row = row_of(camera_rows, Field::up);
constexpr const ValueRow<Camera>& angle_row = row_of(camera_rows, Field::height_angle_deg);
constexpr std::string_view focus_name = "focus";  // in both dialects

// By name, or by order if there are three attributes with other names, like the reader does.
std::optional<VectorSlots> vector_in(std::span<const Attribute> attributes) {
  constexpr std::string_view names[] = {"x", "y", "z"};
  VectorSlots slots;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Attribute& attribute : attributes) {
      if (attribute.name == names[i]) {
        slots[i] = attribute.value;
        ++found;
      }
    }
  }
  if (found == 0 && attributes.size() == 3) {
    return VectorSlots{attributes[0].value, attributes[1].value, attributes[2].value};
  }
  return found == 3 ? std::optional(slots) : std::nullopt;
}

std::optional<NumberSlot> number_in(std::span<const Attribute> attributes) {
  for (const std::string_view name : {"v", "value", "val", "n"}) {
    for (const Attribute& attribute : attributes) {
      if (attribute.name == name) {
        return attribute.value;
      }
    }
  }
  return attributes.size() == 1 ? std::optional(attributes.front().value) : std::nullopt;
}

void take_part(const Tag& tag, CameraSlots& slots) {
  if (tag.name == position_row.xml) {
    slots.position = vector_in(tag.attributes);
  } else if (tag.name == look_row.xml) {
    slots.look = vector_in(tag.attributes);
  } else if (tag.name == focus_name) {
    slots.focus = vector_in(tag.attributes);
  } else if (tag.name == up_row.xml) {
    slots.up = vector_in(tag.attributes);
  } else if (tag.name == angle_row.xml || tag.name == angle_row.xml_alias) {
    slots.height_angle = number_in(tag.attributes);
  }
}

// The line end and the blanks before a tag; empty if the tag is not the first thing on its line.
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

/// Walks the tokens of a file and keeps its last camera.
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

  CameraSlots result() const { return found_ ? camera_ : globals_; }

 private:
  void open(const XmlToken& token) {
    if (depth_ == 1) {
      block_ = tag_of(text_, token).name;
      block_indent_ = indent_before(text_, token.begin);
      if (block_ == "cameradata") {
        found_ = true;
        camera_ = {};
        camera_.indent = block_indent_.empty() ? "" : block_indent_ + "  ";
        if (token.kind == XmlTokenKind::start) {
          camera_.end = token.end;
        }
      }
    } else if (depth_ == 2 && block_ == "cameradata") {
      take_part(tag_of(text_, token), camera_);
      camera_.indent = indent_before(text_, token.begin);
    }
  }

  // Called after the end of an element; depth_ is that of its siblings.
  void close(const XmlToken& token) {
    if (depth_ == 1 && block_ == "globaldata") {
      globals_.end = token.end;
      globals_.indent = block_indent_;
    } else if (depth_ == 2 && block_ == "cameradata") {
      camera_.end = token.end;
    }
  }

  std::string_view text_;
  std::size_t depth_ = 0;
  std::string_view block_;
  std::string block_indent_;
  bool found_ = false;
  CameraSlots camera_;
  CameraSlots globals_;
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

std::optional<NumberSlot> number_slot(const JsonTape& tape, JsonIndex value) {
  if (value == 0 || !tape.is_number(value)) {
    return std::nullopt;
  }
  return NumberSlot{tape.items[value].offset, tape.items[value].extent};
}

std::optional<VectorSlots> json_vector(const JsonTape& tape, JsonIndex value) {
  if (value == 0 || !tape.is_array(value) || tape.items[value].extent != 3) {
    return std::nullopt;
  }
  VectorSlots slots;
  for (JsonIndex i = 0; i < 3; ++i) {
    const std::optional<NumberSlot> slot = number_slot(tape, value + 1 + i);
    if (!slot) {
      return std::nullopt;
    }
    slots[i] = *slot;
  }
  return slots;
}

}  // namespace

CameraSlots xml_camera_slots(std::string_view text) {
  CameraSearch search(text);
  for (const XmlToken& token : xml_tokens(text)) {
    search.take(token);
  }
  return search.result();
}

CameraSlots json_camera_slots(std::string_view text) {
  CameraSlots slots;
  JsonTape tape;
  constexpr std::uint32_t deep = 1 << 20;  // read_scene() has checked the real limit
  if (parse_json(text, deep, tape).fault != JsonFault::none) {
    return slots;
  }
  const JsonIndex camera = member(tape, 0, "cameraData");
  if (camera == 0) {
    return slots;
  }
  slots.position = json_vector(tape, member(tape, camera, position_row.json));
  slots.look = json_vector(tape, member(tape, camera, look_row.json));
  slots.focus = json_vector(tape, member(tape, camera, focus_name));
  slots.up = json_vector(tape, member(tape, camera, up_row.json));
  slots.height_angle = number_slot(tape, member(tape, camera, angle_row.json));
  return slots;
}

}  // namespace scenefile
