#pragma once
// Handles in the picture that move, turn and scale the selection: an object, a light (its position,
// direction and cone) or the scene's camera. Places in the window are as in session.h.

#include "scenefile/edit/edits.h"
#include "scenefile/scene/render_scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace scenefile::viewer {

struct Session;

/// What the handles do.
enum class Handles : std::uint8_t { move, turn, scale, none };

/// The handles of the selection.
struct HandleSet {
  Handles kind = Handles::move;
  std::optional<Handle> of_item{};    ///< else a light of an XML file, or the camera
  std::optional<RenderLight> spot{};  ///< with the edges of its cone; kind none: only these
  bool of_camera = false;
  glm::dvec3 at{0};                  ///< world space
  std::array<glm::dvec3, 3> axes{};  ///< unit length, world space
};

/// A handle as it is drawn: a line for moving and scaling, a ring for turning, a point in the
/// middle, a part of the edge of a cone.
struct HandleLine {
  int number = 0;  ///< of the axis; 3: all; 4, 5: outer and inner edge of a cone, by quarters
  std::vector<glm::dvec2> points;
};

/// The handle that the pointer holds.
struct GraspedHandle {
  HandleSet set;
  int number = 0;
  glm::dvec2 pressed{0};
  glm::dvec2 last{0};
  double turned_deg = 0;
};

/// The handles to show; nullopt: nothing that they could move is selected.
std::optional<HandleSet> handles_of(Session& session);
/// In the window; empty if the handles are behind the camera.
std::vector<HandleLine> handle_lines(const Session& session, const HandleSet& set);
/// The number of the handle at a place.
std::optional<int> handle_at(const Session& session, const HandleSet& set, const glm::dvec2& at);

/// Takes the handle under the pointer, if there is one.
bool grasp_handle(Session& session);
/// Edits the selection so that the handle follows the pointer; `steps`: in coarse steps.
void drag_handle(Session& session, bool steps);

}  // namespace scenefile::viewer
