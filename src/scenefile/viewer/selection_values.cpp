#include "scenefile/viewer/selection_values.h"

#include "scenefile/base/shape_traits.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile::viewer {

namespace {

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

class Values {
 public:
  void add(const char* name, std::string text) { list.push_back({name, std::move(text)}); }
  void add_color(const char* name, const glm::vec3& color) {
    if (color != glm::vec3(0)) {
      list.push_back({name, fmt::format("{:.4g} {:.4g} {:.4g}", color.r, color.g, color.b), color});
    }
  }
  void add_material(const RenderScene& scene, const RenderMaterial& m) {
    add_color("ambient", m.ambient);
    add_color("diffuse", m.diffuse);
    add_color("specular", m.specular);
    add_color("reflective", m.reflective);
    add_color("transparent", m.transparent);
    if (m.specular != glm::vec3(0)) {
      add("shininess", fmt::format("{:.4g}", m.shininess));
    }
    if (m.transparent != glm::vec3(0)) {
      add("ior", fmt::format("{:.4g}", m.ior));
    }
    if (m.texture.used()) {
      add("texture", file_name_of(scene.texture_files[m.texture.file].name));
    }
  }
  void add_light(const RenderLight& light) {
    add_color("color", light.color);
    if (has_position(light.type)) {
      add("position", vector_text(light.position));
      add("attenuation", vector_text(light.attenuation));
    }
    if (has_direction(light.type)) {
      add("direction", vector_text(light.direction));
    }
  }

  std::vector<NamedValue> list;
};

const RenderPrimitive* find_primitive(const RenderScene& scene, std::uint32_t source) {
  for (const RenderGroup& group : scene.groups) {
    for (const RenderPrimitive& primitive : group.primitives) {
      if (primitive.source == source) {
        return &primitive;
      }
    }
  }
  return nullptr;
}

std::string lines_of(const std::vector<NamedValue>& values) {
  std::string text;
  for (const NamedValue& value : values) {
    text += fmt::format("{} {}\n", value.name, value.text);
  }
  return text;
}

std::string selection_text(const Session& session) {
  const OutlineRow& row = session.shown->outline.rows[*session.selected];
  std::string text = row.label;
  if (row.location.known()) {
    text += fmt::format(" {}:{}:{}", session.shown->opened.path, row.location.line,
                        row.location.column);
  }
  text += '\n';
  if (!session.selected_path.empty()) {
    text += session.selected_path + '\n';
  }
  return text + lines_of(selection_values(session));
}

}  // namespace

std::vector<NamedValue> selection_values(const Session& session) {
  if (!session.selected || session.shown == nullptr) {
    return {};
  }
  const OutlineRow& row = session.shown->outline.rows[*session.selected];
  const RenderScene& scene = session.shown->opened.ready.scene;
  Values values;
  switch (row.kind) {
    case RowKind::primitive:
      if (const RenderPrimitive* const primitive = find_primitive(scene, row.source)) {
        values.add_material(scene, scene.materials[primitive->material]);
      }
      break;
    case RowKind::light:
      for (const RenderLight& light : scene.lights) {
        if (light.source == row.source) {
          values.add_light(light);
        }
      }
      break;
    case RowKind::camera:
      return camera_values(session.home);
    case RowKind::copy:
    case RowKind::group:
    case RowKind::templates:
      break;
  }
  return values.list;
}

std::vector<NamedValue> camera_values(const ViewCamera& camera) {
  Values values;
  values.add("pos", vector_text(camera.position));
  values.add("look", vector_text(camera.pivot - camera.position));
  values.add("up", vector_text(camera.up));
  values.add("heightangle", fmt::format("{:.6g}", camera.height_angle_deg));
  return values.list;
}

CopiedText text_to_copy(const Session& session) {
  if (session.shown == nullptr) {
    return {};
  }
  if (session.readout.at) {
    return {"the pixel", readout_text(session)};
  }
  if (session.selected) {
    return {"the selection", selection_text(session)};
  }
  return {"the camera", lines_of(camera_values(session.camera))};
}

}  // namespace scenefile::viewer
