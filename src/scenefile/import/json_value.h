#pragma once
// A value in a parsed JSON document. Internal to import.

#include "scenefile/format/json_parser.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A place in a document, or nothing; any member of nothing is nothing. Cheap to copy.
class JsonValue {
 public:
  JsonValue() = default;
  JsonValue(const JsonTape& tape, JsonIndex at) : tape_(&tape), at_(at) {}

  explicit operator bool() const { return tape_ != nullptr; }
  bool is_object() const { return tape_ != nullptr && tape_->is_object(at_); }
  bool is_array() const { return tape_ != nullptr && tape_->is_array(at_); }

  /// The first member with that name. Takes time linear in the size of the object.
  JsonValue operator[](std::string_view name) const;
  /// The elements of an array; empty for any other value.
  std::vector<JsonValue> elements() const;

  /// Whether it is written as a number, also one that is too large for number().
  bool is_number() const { return tape_ != nullptr && tape_->is_number(at_); }

  bool is_true() const { return tape_ != nullptr && tape_->first_character(at_) == 't'; }
  std::optional<double> number() const;
  /// An integer from 0 to 2^53; nullopt for any other value.
  std::optional<std::uint64_t> whole() const;
  std::optional<std::string> string() const;
  /// An array of exactly that many numbers.
  std::optional<std::vector<double>> numbers(std::size_t count) const;
  std::optional<glm::vec3> color() const;

 private:
  const JsonTape* tape_ = nullptr;
  JsonIndex at_ = 0;
};

}  // namespace scenefile
