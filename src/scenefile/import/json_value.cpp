#include "scenefile/import/json_value.h"

#include "scenefile/base/number.h"

#include <cmath>

namespace scenefile {

JsonValue JsonValue::operator[](std::string_view name) const {
  if (!is_object()) {
    return {};
  }
  const JsonIndex end = tape_->end(at_);
  for (JsonIndex key = at_ + 1; key < end; key = tape_->end(key + 1)) {
    if (tape_->raw(key) == name) {
      return {*tape_, key + 1};
    }
  }
  return {};
}

std::vector<JsonValue> JsonValue::elements() const {
  std::vector<JsonValue> list;
  if (is_array()) {
    const JsonIndex end = tape_->end(at_);
    for (JsonIndex item = at_ + 1; item < end; item = tape_->end(item)) {
      list.emplace_back(*tape_, item);
    }
  }
  return list;
}

std::optional<double> JsonValue::number() const {
  if (!is_number()) {
    return std::nullopt;
  }
  const ParsedNumber parsed = parse_number(tape_->raw(at_));
  return parsed.error == NumberError::none ? std::optional(parsed.value) : std::nullopt;
}

std::optional<std::uint64_t> JsonValue::whole() const {
  const std::optional<double> value = number();
  constexpr double most = 9007199254740992.0;
  if (!value || *value < 0 || *value > most || std::floor(*value) != *value) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(*value);
}

std::optional<std::string> JsonValue::string() const {
  return tape_ != nullptr && tape_->is_string(at_) ? std::optional(tape_->string(at_))
                                                   : std::nullopt;
}

std::optional<std::vector<double>> JsonValue::numbers(std::size_t count) const {
  if (!is_array() || tape_->items[at_].extent != count) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const JsonValue& element : elements()) {
    const std::optional<double> value = element.number();
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values.size() == count ? std::optional(values) : std::nullopt;
}

std::optional<glm::vec3> JsonValue::color() const {
  const auto values = numbers(3);
  return values ? std::optional(glm::vec3((*values)[0], (*values)[1], (*values)[2])) : std::nullopt;
}

}  // namespace scenefile
