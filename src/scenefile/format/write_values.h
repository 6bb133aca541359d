#pragma once
// Writes values by the rows of the vocabulary, for both formats. Internal to format. A Printer has
// name_of(row), which is empty for what its format cannot represent, value(name, float),
// three(name, kind, vec3), id(name, int, place), text(name, text, place) and image(row, use).

#include "scenefile/scene/vocabulary.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace scenefile {

/// Writes a value; skips an optional value that is absent.
template <typename Printer, typename Owner>
void print_value(Printer& to, const ValueRow<Owner>& row, const Owner& owner, Location place) {
  const std::string_view name = to.name_of(row);
  if (const auto* const number = std::get_if<float Owner::*>(&row.member)) {
    to.value(name, owner.**number);
  } else if (const auto* const vector = std::get_if<glm::vec3 Owner::*>(&row.member)) {
    to.three(name, row.kind, owner.**vector);
  } else if (const auto* const maybe = std::get_if<std::optional<float> Owner::*>(&row.member)) {
    if (owner.**maybe) {
      to.value(name, *(owner.**maybe));
    }
  } else if (const auto* const id = std::get_if<std::optional<int> Owner::*>(&row.member)) {
    if (owner.**id) {
      to.id(name, *(owner.**id), place);
    }
  } else if (const auto* const text = std::get_if<std::string Owner::*>(&row.member)) {
    if (!(owner.**text).empty()) {
      to.text(name, owner.**text, place);
    }
  } else if (const auto* const use = std::get_if<Rare<TextureUse> Owner::*>(&row.member)) {
    if (owner.**use) {
      to.image(row, *(owner.**use));
    }
  }
}

/// Whether the value equals the default.
template <typename Owner>
bool is_default(const ValueRow<Owner>& row, const Owner& owner) {
  static const Owner defaults;
  return std::visit(
      [&](const auto& member) {
        if constexpr (std::is_same_v<decltype(member), const std::monostate&>) {
          return true;
        } else {
          return owner.*member == defaults.*member;
        }
      },
      row.member);
}

template <typename Printer>
void print_values(Printer& to, const Global& global) {
  for (const ValueRow<Global>& row : global_rows) {
    print_value(to, row, global, global.location);
  }
}

/// Only the values that the light's type uses.
template <typename Printer>
void print_values(Printer& to, const Light& light) {
  for (const ValueRow<Light>& row : light_rows) {
    if (to.name_of(row).empty()) {
      continue;
    }
    if (row.kind == ValueKind::choice) {
      to.text(to.name_of(row), word_of(light.type), light.location);
    } else if (row.used_by_type(light.type) || (to.is_idle(row) && !is_default(row, light))) {
      print_value(to, row, light, light.location);
    }
  }
}

/// Only the values that differ from the default.
template <typename Printer>
void print_values(Printer& to, const Material& material) {
  static constexpr auto rows = as_written(material_rows);
  for (const ValueRow<Material>* row : rows) {
    if (!is_default(*row, material)) {
      print_value(to, *row, material, {});
    }
  }
}

/// The given values of a camera.
template <typename Printer>
void print_values(Printer& to, const Camera& camera, std::initializer_list<Field> fields) {
  for (const Field field : fields) {
    print_value(to, row_of(camera_rows, field), camera, camera.location);
  }
  if (camera.aperture != 0 || camera.focal_length != 0) {
    print_value(to, row_of(camera_rows, Field::aperture), camera, camera.location);
    print_value(to, row_of(camera_rows, Field::focal_length), camera, camera.location);
  }
}

}  // namespace scenefile
