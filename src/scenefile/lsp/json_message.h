#pragma once
// Reads the members of a JSON-RPC message. Internal to lsp.

#include "scenefile/format/json_parser.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A value of a message, or nothing: then its members are nothing, too.
class JsonView {
 public:
  JsonView() = default;
  JsonView(const JsonTape& tape, JsonIndex at) : tape_(&tape), at_(at) {}

  bool exists() const { return tape_ != nullptr; }
  bool is_object() const { return exists() && tape_->is_object(at_); }
  /// The member, or nothing.
  JsonView operator[](std::string_view name) const;
  /// The elements of an array.
  std::vector<JsonView> elements() const;
  /// The text; empty if it is not a string.
  std::string string() const;
  /// 0 if it is not a number.
  double number() const;
  bool is_true() const { return exists() && tape_->raw(at_) == "true"; }
  /// As in the message; null for objects and arrays.
  std::string_view raw() const;

 private:
  const JsonTape* tape_ = nullptr;
  JsonIndex at_ = 0;
};

}  // namespace scenefile
