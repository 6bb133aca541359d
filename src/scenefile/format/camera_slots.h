#pragma once
// Where the numbers of the camera stand in the bytes of a scene file. Private to the room.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scenefile {

/// The bytes of one number.
struct NumberSlot {
  std::size_t offset = 0;
  std::size_t length = 0;
};
using VectorSlots = std::array<NumberSlot, 3>;

/// What the camera of a file says; what it does not say is missing.
struct CameraSlots {
  std::optional<VectorSlots> position;
  std::optional<VectorSlots> look;
  std::optional<VectorSlots> focus;
  std::optional<VectorSlots> up;
  std::optional<NumberSlot> height_angle;

  /// Where an element of the camera may be added, XML alone, and the line end and blanks that
  /// belong before it.
  std::optional<std::size_t> end;
  std::string indent;
  /// There is no camera: `end` is where one may be added, behind the element at `indent`.
  bool missing = false;
};

/// Of a text that read_scene() accepts: UTF-8 or another encoding whose bytes below 128 are ASCII,
/// without a byte order mark.
CameraSlots xml_camera_slots(std::string_view text);
/// The same, strict JSON; where numbers were repaired nothing is found.
CameraSlots json_camera_slots(std::string_view text);

}  // namespace scenefile
