#include "scenefile/viewer/copied_text.h"

#include <fmt/format.h>

namespace scenefile::viewer {

namespace {

std::string vector_text(const glm::dvec3& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z);
}

std::string camera_text(const ViewCamera& camera) {
  return fmt::format("pos {}\nlook {}\nup {}\nheightangle {:.6g}\n", vector_text(camera.position),
                     vector_text(camera.pivot - camera.position), vector_text(camera.up),
                     camera.height_angle_deg);
}

std::string selection_text(Session& session) {
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
  if (const std::optional<ItemId> item = selected_item(session)) {
    for (const FieldView& field : session.editing.document->fields(*item)) {
      if (field.written) {
        text += field.name;
        for (const FieldPart& part : field.parts) {
          text += ' ' + part.value;
        }
        text += '\n';
      }
    }
  }
  return text;
}

}  // namespace

CopiedText text_to_copy(Session& session) {
  if (session.shown == nullptr) {
    return {};
  }
  if (session.readout.at) {
    return {"the pixel", readout_text(session)};
  }
  if (session.selected) {
    return {"the selection", selection_text(session)};
  }
  return {"the camera", camera_text(session.camera)};
}

}  // namespace scenefile::viewer
