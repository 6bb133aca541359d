#include "scenefile/format/xml_camera.h"

#include "scenefile/format/codes.h"
#include "scenefile/format/direction.h"
#include "scenefile/format/xml_values.h"

#include <fmt/format.h>

#include <optional>

namespace scenefile {

namespace {

enum GlobalField : std::size_t { g_ambient, g_diffuse, g_specular, g_transparent };

constexpr FieldName global_names[] = {{"ambientcoeff", g_ambient},
                                      {"diffusecoeff", g_diffuse},
                                      {"specularcoeff", g_specular},
                                      {"transparentcoeff", g_transparent}};

enum CameraField : std::size_t {
  c_pos,
  c_look,
  c_focus,
  c_up,
  c_height_angle,
  c_aspect_ratio,
  c_aperture,
  c_focal_length
};

constexpr FieldName camera_names[] = {{"pos", c_pos},
                                      {"look", c_look},
                                      {"focus", c_focus},
                                      {"up", c_up},
                                      {"heightangle", c_height_angle},
                                      {"angle", c_height_angle, true},
                                      {"aspectratio", c_aspect_ratio},
                                      {"aperture", c_aperture},
                                      {"focallength", c_focal_length}};

void set(float& member, std::optional<float> value) {
  member = value.value_or(not_known);
}

void set(glm::vec3& member, const std::optional<glm::vec3>& value) {
  member = value.value_or(glm::vec3(not_known));
}

void report_default(const XmlContext& context, const CameraDraft& draft, std::string_view part,
                    std::string_view value) {
  context.diagnostics.report(
      xml_camera_default, draft.camera.location,
      fmt::format("<cameradata> has no {}; the default {} is used", part, value));
}

void report_defaults(const XmlContext& context, const CameraDraft& draft) {
  if (!draft.seen.has(c_pos)) {
    report_default(context, draft, "<pos>", "5 5 5");
  }
  if (!draft.seen.has(c_look) && !draft.seen.has(c_focus)) {
    report_default(context, draft, "<look> or <focus>", "look -1 -1 -1");
  }
  if (!draft.seen.has(c_up)) {
    report_default(context, draft, "<up>", "0 1 0");
  }
  if (!draft.seen.has(c_height_angle)) {
    report_default(context, draft, "<heightangle>", "45");
  }
}

// A focus is a point to look at; behind the reader there are directions only.
void resolve_focus(const XmlContext& context, CameraDraft& draft) {
  const Location look = draft.seen.place(c_look);
  const Location focus = draft.seen.place(c_focus);
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

void add_places(const CameraDraft& draft, Scene& scene) {
  const auto add = [&](std::size_t field, Field member) {
    if (draft.seen.has(field)) {
      scene.field_places.push_back({draft.camera.location, member, draft.seen.place(field)});
    }
  };
  add(c_pos, Field::position);
  add(c_look, Field::look);
  add(c_focus, Field::look);
  add(c_up, Field::up);
  add(c_height_angle, Field::height_angle_deg);
  add(c_aperture, Field::aperture);
  add(c_focal_length, Field::focal_length);
}

}  // namespace

bool read_global(const XmlContext& context, const XmlTag& tag, SeenFields& seen, Scene& scene) {
  const std::optional<std::size_t> field = find_field(context, tag, global_names, "globaldata");
  if (!field) {
    return false;
  }
  seen.note(context, tag, *field);
  const std::optional<float> value = read_single(context, tag);
  const auto store = [&](Field member) {
    scene.field_places.push_back({scene.global.location, member, tag.location});
  };
  switch (static_cast<GlobalField>(*field)) {
    case g_ambient:
      set(scene.global.ambient, value);
      store(Field::ambient);
      break;
    case g_diffuse:
      set(scene.global.diffuse, value);
      store(Field::diffuse);
      break;
    case g_specular:
      set(scene.global.specular, value);
      store(Field::specular);
      break;
    case g_transparent:
      scene.global.transparent = value.value_or(not_known);
      store(Field::transparent);
      break;
  }
  return true;
}

bool read_camera_part(const XmlContext& context, const XmlTag& tag, CameraDraft& draft) {
  const std::optional<std::size_t> field = find_field(context, tag, camera_names, "cameradata");
  if (!field) {
    return false;
  }
  draft.seen.note(context, tag, *field);
  Camera& camera = draft.camera;
  switch (static_cast<CameraField>(*field)) {
    case c_pos:
      set(camera.position, read_vector(context, tag));
      break;
    case c_look:
      set(camera.look, read_vector(context, tag));
      break;
    case c_focus:
      set(draft.focus, read_vector(context, tag));
      break;
    case c_up:
      set(camera.up, read_vector(context, tag));
      break;
    case c_height_angle:
      set(camera.height_angle_deg, read_single(context, tag));
      break;
    case c_aspect_ratio:
      context.diagnostics.report(xml_ignored_element, Severity::note, tag.location,
                                 "<aspectratio> has no effect: the picture's size decides");
      break;
    case c_aperture:
      set(camera.aperture, read_single(context, tag));
      break;
    case c_focal_length:
      set(camera.focal_length, read_single(context, tag));
      break;
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
  add_places(draft, scene);
  scene.camera = draft.camera;
}

}  // namespace scenefile
