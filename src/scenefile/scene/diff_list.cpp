#include "scenefile/scene/diff_list.h"

#include "scenefile/scene/check_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace scenefile {

std::uint64_t mixed(std::uint64_t seed, std::uint64_t value) {
  const std::uint64_t x = (seed ^ value) * 0x9e3779b97f4a7c15u;
  return x ^ (x >> 29);
}

std::uint64_t hash_of(const Values& values) {
  std::uint64_t hash = values.size();
  for (const Value& value : values) {
    hash = mixed(hash, std::hash<std::string_view>{}(value.name));
    hash = mixed(hash, std::hash<std::string>{}(value.text));
  }
  return hash;
}

std::string_view label_of(const Light& light) {
  return light_type_name(light.type);
}

std::string_view label_of(const Primitive& primitive) {
  return word_of(primitive.shape);
}

std::string described(std::string_view label, const Values& values) {
  std::string text(label);
  for (const Value& value : values) {
    if (value.name != "type") {
      text += fmt::format(", {} {}", value.name, value.text);
    }
  }
  return text;
}

std::string place_text(std::size_t index) {
  return fmt::format("place {}", index + 1);
}

std::vector<std::string> numbered(const std::vector<std::string_view>& labels) {
  std::map<std::string_view, std::size_t> counts;
  std::vector<std::string> result;
  for (const std::string_view label : labels) {
    result.push_back(fmt::format("{} {}", label, ++counts[label]));
  }
  return result;
}

void DifferenceList::add(std::string where, std::string a, std::string b, Location in_a,
                         Location in_b) {
  if (!full()) {
    differences_.push_back({std::move(where), std::move(a), std::move(b), in_a, in_b});
  }
}

void DifferenceList::compare_values(const std::string& where, const Values& a, const Values& b,
                                    Location in_a, Location in_b) {
  const auto find = [](const Values& values, std::string_view name) {
    for (const Value& value : values) {
      if (value.name == name) {
        return value.text;
      }
    }
    return default_text(name);
  };
  for (const Value& value : a) {
    const std::string other = find(b, value.name);
    if (value.text != other) {
      add(where + std::string(value.name), value.text, other, in_a, in_b);
    }
  }
  for (const Value& value : b) {
    if (std::none_of(a.begin(), a.end(), [&](const Value& v) { return v.name == value.name; })) {
      add(where + std::string(value.name), default_text(value.name), value.text, in_a, in_b);
    }
  }
}

}  // namespace scenefile
