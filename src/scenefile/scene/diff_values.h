#pragma once
// The values of a scene as text, for comparison and hashing. Internal to scene.

#include "scenefile/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace scenefile {

/// A value that differs from the default, named as in the files. Equal texts mean equal values.
struct Value {
  std::string_view name;
  std::string text;

  friend bool operator==(const Value&, const Value&) = default;
};
using Values = std::vector<Value>;

/// The text of a value's default; "none" if it has no default.
std::string default_text(std::string_view name);

Values values_of(const Global& global);
Values values_of(const Camera& camera);
Values values_of(const Light& light);
Values values_of(const Primitive& primitive);
/// Only of the node itself, not of its contents.
Values values_of(const Node& node);

}  // namespace scenefile
