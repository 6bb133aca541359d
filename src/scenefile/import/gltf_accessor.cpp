#include "scenefile/import/gltf_accessor.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace scenefile {

namespace {

// componentType of the specification, section 3.6.2.2.
enum class Component : std::uint64_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

std::size_t size_of(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    case Component::uint32:
    case Component::float32:
      return 4;
  }
  return 0;
}

template <typename T>
T load(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <typename T>
float fraction(const char* at, bool normalized) {
  const auto value = static_cast<float>(load<T>(at));
  return normalized ? std::max(-1.0f, value / static_cast<float>(std::numeric_limits<T>::max()))
                    : value;
}

float number(const char* at, Component component, bool normalized) {
  switch (component) {
    case Component::int8:
      return fraction<std::int8_t>(at, normalized);
    case Component::uint8:
      return fraction<std::uint8_t>(at, normalized);
    case Component::int16:
      return fraction<std::int16_t>(at, normalized);
    case Component::uint16:
      return fraction<std::uint16_t>(at, normalized);
    case Component::uint32:
      return fraction<std::uint32_t>(at, normalized);
    case Component::float32:
      break;
  }
  return load<float>(at);
}

// The memory layout of the elements; all of them are inside the file.
struct Layout {
  const char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
  Component component = Component::float32;
  bool normalized = false;
};

std::string_view type_name(std::size_t components) {
  constexpr std::string_view names[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  return names[components - 1];
}

Result<Layout> find_layout(const GltfFile& file, std::uint32_t index, std::size_t components) {
  if (index >= file.accessors.size()) {
    return input_error(" does not exist");
  }
  const JsonValue& accessor = file.accessors[index];
  if (accessor["sparse"]) {
    return input_error(" is sparse, which is not supported");
  }
  Layout layout;
  layout.component = static_cast<Component>(accessor["componentType"].whole().value_or(0));
  const std::size_t size = size_of(layout.component) * components;
  if (size == 0 || accessor["type"].string().value_or("") != type_name(components)) {
    return input_error(
        fmt::format(" should be a {} of a known component type", type_name(components)));
  }
  layout.normalized = false;
  if (const JsonValue normalized = accessor["normalized"]) {
    layout.normalized = normalized.is_true();
  }
  const std::uint64_t view = accessor["bufferView"].whole().value_or(no_item);
  const std::uint64_t count = element_count(file, index);
  const std::uint64_t offset =
      accessor["byteOffset"] ? accessor["byteOffset"].whole().value_or(~std::uint64_t{0}) : 0;
  if (view >= file.views.size() || count == 0) {
    return input_error(" has no bufferView or no elements");
  }
  const std::string_view bytes = file.views[view].bytes;
  layout.stride = file.views[view].stride == 0 ? size : file.views[view].stride;
  if (layout.stride < size || offset > bytes.size() || size > bytes.size() - offset ||
      (bytes.size() - offset - size) / layout.stride < count - 1) {
    return input_error(" points outside of its bufferView");
  }
  layout.first = bytes.data() + offset;
  layout.count = count;
  return layout;
}

}  // namespace

std::uint64_t element_count(const GltfFile& file, std::uint32_t accessor) {
  return accessor < file.accessors.size() ? file.accessors[accessor]["count"].whole().value_or(0)
                                          : 0;
}

Result<std::vector<float>> read_floats(const GltfFile& file, std::uint32_t accessor,
                                       std::size_t components) {
  const Result<Layout> found = find_layout(file, accessor, components);
  if (!found) {
    return found.error();
  }
  const Layout& layout = *found;
  std::vector<float> values;
  values.reserve(layout.count * components);
  const std::size_t size = size_of(layout.component);
  for (std::size_t i = 0; i < layout.count; ++i) {
    for (std::size_t k = 0; k < components; ++k) {
      const float value =
          number(layout.first + i * layout.stride + k * size, layout.component, layout.normalized);
      if (!std::isfinite(value)) {
        return input_error(fmt::format(" has a number that is not finite, in element {}", i));
      }
      values.push_back(value);
    }
  }
  return values;
}

Result<std::vector<std::uint32_t>> read_indices(const GltfFile& file, std::uint32_t accessor) {
  const Result<Layout> found = find_layout(file, accessor, 1);
  if (!found) {
    return found.error();
  }
  const Layout& layout = *found;
  std::vector<std::uint32_t> values;
  values.reserve(layout.count);
  for (std::size_t i = 0; i < layout.count; ++i) {
    const char* const at = layout.first + i * layout.stride;
    switch (layout.component) {
      case Component::uint8:
        values.push_back(load<std::uint8_t>(at));
        break;
      case Component::uint16:
        values.push_back(load<std::uint16_t>(at));
        break;
      case Component::uint32:
        values.push_back(load<std::uint32_t>(at));
        break;
      case Component::int8:
      case Component::int16:
      case Component::float32:
        return input_error(" contains indices, which must be unsigned");
    }
  }
  return values;
}

}  // namespace scenefile
