#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/read_common.h"
#include "scenefile/format/xml_blocks.h"

#include <fmt/format.h>

#include <optional>

namespace scenefile {

namespace {

constexpr auto global_names = names_of<count_names(global_rows)>(global_rows);
constexpr auto camera_names = names_of<count_names(camera_rows)>(camera_rows);

// The second row with Field::look: the point to look at.
constexpr std::size_t focus_row = 2;
static_assert(camera_rows[focus_row].xml == "focus");

Location place_of(const CameraDraft& draft, Field field) {
  return draft.seen.place(index_of(camera_rows, field));
}

void report_default(const XmlContext& context, const CameraDraft& draft, std::string_view part,
                    std::string_view value) {
  context.diagnostics.report(
      xml_camera_default, draft.camera.location,
      fmt::format("<cameradata> has no {}; the default {} is used", part, value));
}

void report_defaults(const XmlContext& context, const CameraDraft& draft) {
  if (!place_of(draft, Field::position).known()) {
    report_default(context, draft, "<pos>", "5 5 5");
  }
  if (!place_of(draft, Field::look).known() && !draft.seen.has(focus_row)) {
    report_default(context, draft, "<look> or <focus>", "look -1 -1 -1");
  }
  if (!place_of(draft, Field::up).known()) {
    report_default(context, draft, "<up>", "0 1 0");
  }
  if (!place_of(draft, Field::height_angle_deg).known()) {
    report_default(context, draft, "<heightangle>", "45");
  }
}

// A focus is a point to look at; the scene only has directions.
void resolve_focus(const XmlContext& context, CameraDraft& draft) {
  const Location look = place_of(draft, Field::look);
  const Location focus = draft.seen.place(focus_row);
  if (!focus.known()) {
    return;
  }
  if (look.known()) {
    const bool focus_last =
        focus.line > look.line || (focus.line == look.line && focus.column > look.column);
    context.diagnostics.report(
        xml_look_and_focus, focus_last ? focus : look,
        fmt::format("<cameradata> has both <look> and <focus>; the other one is at line {}",
                    (focus_last ? look : focus).line));
    draft.camera.look = glm::vec3(not_known);
    return;
  }
  const glm::vec3 direction = direction_to(draft.focus, draft.camera.position);
  if (direction == glm::vec3(0)) {
    context.diagnostics.report(
        xml_focus_at_position, focus,
        "<focus> is the position of the camera itself, so there is no direction to look in");
  }
  draft.camera.look = direction == glm::vec3(0) ? glm::vec3(not_known) : direction;
}

// The aspect ratio has no effect, but an invalid one may hide a mistake.
void report_aspect_ratio(const XmlContext& context, const XmlTag& tag) {
  const XmlAttribute* const v = tag.find("v");
  const XmlAttribute* const given = v != nullptr ? v : tag.find("value");
  const ParsedNumber number = parse_number(given != nullptr ? given->value : "1");
  const bool is_ratio = number.error == NumberError::none && number.value > 0;
  context.diagnostics.report(
      xml_ignored_element, is_ratio ? Severity::note : Severity::warning, tag.location,
      fmt::format("<aspectratio>{} has no effect: the picture's size decides",
                  is_ratio ? "" : fmt::format(" {} is not a ratio, and", quoted(given->value))));
}

}  // namespace

bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, global_names, "globaldata");
  if (!field) {
    return false;
  }
  seen.note(context, tag, *field);
  const ValueRow<Global>& row = global_rows[*field];
  read_value(context, tag, row, scene.global);
  scene.field_places.push_back({scene.global.location, *row.field, tag.location});
  return true;
}

bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft) {
  const std::optional<std::size_t> field = find_field(context, tag, camera_names, "cameradata");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  const ValueRow<Camera>& row = camera_rows[*field];
  if (*field == focus_row) {
    draft.focus = read_three(context, tag, row.kind).value_or(glm::vec3(not_known));
  } else if (row.has_member()) {
    read_value(context, tag, row, draft.camera);
  } else {
    report_aspect_ratio(context, tag);
  }
  return true;
}

void finish_camera(const XmlContext& context, CameraDraft& draft, Scene& scene) {
  report_defaults(context, draft);
  resolve_focus(context, draft);
  if (scene.camera) {
    context.diagnostics.report(xml_second_camera, draft.camera.location,
                               fmt::format("a second <cameradata>, after line {}; this one counts",
                                           scene.camera->location.line));
  }
  add_places(camera_rows, draft.seen, draft.camera.location, scene);
  scene.camera = draft.camera;
}

}  // namespace scenefile
