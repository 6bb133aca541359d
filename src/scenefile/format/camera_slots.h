#pragma once
// Locates the camera's numbers in the bytes of a scene file. Private to the room.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The byte range of one number.
struct NumberSlot {
  std::size_t offset = 0;
  std::size_t length = 0;
};
using VectorSlots = std::array<NumberSlot, 3>;

/// The values that a file gives for its camera; nullopt for those it does not give.
struct CameraSlots {
  std::optional<VectorSlots> position;
  std::optional<VectorSlots> look;
  std::optional<VectorSlots> focus;
  std::optional<VectorSlots> up;
  std::optional<NumberSlot> height_angle;

  /// Where an element can be added to the camera (XML only), and the line end and indentation to
  /// put before it.
  std::optional<std::size_t> end;
  std::string indent;
  /// The file has no camera: one can be added at `end`, after the element indented by `indent`.
  bool missing = false;
};

/// Requires a text that read_scene() accepts, in UTF-8 or another superset of ASCII, without a byte
/// order mark.
CameraSlots xml_camera_slots(std::string_view text);
/// Same for strict JSON; finds nothing where numbers were repaired.
CameraSlots json_camera_slots(std::string_view text);

}  // namespace scenefile
