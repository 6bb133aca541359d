#pragma once
// Reads the values of a block (global data, a camera, a light or a material) into the members of
// its rows: what is the same in XML and JSON. Internal to format.

#include "scenefile/scene/vocabulary.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <variant>

namespace scenefile {

/// Whether the place of these three numbers must be stored, because a finding could refer to them
/// or because the scene has few values so far. Scenes with a million objects have as many ordinary
/// colors, to which only the causes of a picture's differences could refer.
bool needs_place(Field field, const glm::vec3& value, const Scene& scene);

/// The values of a block, and where what is known of them is stored.
template <typename Owner>
struct BlockReader {
  Owner& values;
  FieldSet& unread;
  Location location;
  Scene& scene;

  /// Reads a value as written; after an error, the member has its default. `Value` is one of the
  /// syntaxes; `number(float&)` and `three(ValueKind, glm::vec3&)` return false after an error.
  template <typename Value>
  void read(const ValueRow<Owner>& row, const Value& value) const {
    const auto store = [&](const auto member, bool known) {
      static const Owner defaults;
      if (!known) {
        values.*member = defaults.*member;
      }
      unread.set(*row.field, !known);
    };
    const auto* const vector = std::get_if<glm::vec3 Owner::*>(&row.member);
    if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
      store(*number, value.number(values.**number));
    } else if (const auto* const maybe = std::get_if<std::optional<float> Owner::*>(&row.member)) {
      store(*maybe, value.number((values.**maybe).emplace()));
    } else if (vector != nullptr) {
      store(*vector, value.three(row.kind, values.**vector));
    }
    if (vector == nullptr || needs_place(*row.field, values.**vector, scene)) {
      note(*row.field, value);
    }
  }

  /// Stores the place of a value.
  template <typename Value>
  void note(Field field, const Value& value) const {
    scene.field_places.push_back({location, field, value.place()});
  }
};

inline constexpr std::size_t look_row = index_of(camera_rows, Field::look);
inline constexpr std::size_t focus_row = look_row + 1;
static_assert(camera_rows[focus_row].xml == "focus" && camera_rows[focus_row].json == "focus");

/// Reads a focus, a point to look at; the scene only has directions.
template <typename Value>
void read_focus(const BlockReader<Camera>& block, const Value& value, glm::vec3& focus) {
  block.unread.set(Field::look, !value.three(ValueKind::vector, focus));
  block.note(Field::look, value);
}

/// Sets the direction of view; it is unread if the focus or the position is.
void look_at(const glm::vec3& focus, Camera& camera);

}  // namespace scenefile
