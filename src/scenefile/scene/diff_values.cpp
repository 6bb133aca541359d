#include "scenefile/scene/diff_values.h"

#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/scene/check_parts.h"
#include "scenefile/scene/vocabulary.h"

#include <fmt/format.h>

#include <type_traits>
#include <utility>
#include <variant>

namespace scenefile {

namespace {

// Adding 0.0f gives -0 and 0 the same text, because they are equal.
std::string text_of(float value) {
  return number_text(value + 0.0f);
}
std::string text_of(const glm::vec3& value) {
  return vector_text(value + glm::vec3(0.0f));
}
std::string text_of(int value) {
  return fmt::format("{}", value);
}
std::string text_of(const std::string& value) {
  return quoted(value, value.size());
}
std::string text_of(const TextureUse& use) {
  return fmt::format("{} repeated {} by {}", text_of(use.file), text_of(use.repeat_u),
                     text_of(use.repeat_v));
}

template <typename T>
std::string text_of(const std::optional<T>& value) {
  return value ? text_of(*value) : "none";
}
std::string text_of(const Rare<TextureUse>& use) {
  return use ? text_of(*use) : "none";
}

std::string text_of(const Translate& t) {
  return fmt::format("{} {}", transform_word<Translate>, text_of(t.by));
}
std::string text_of(const Rotate& r) {
  return fmt::format("{} {} about {}", transform_word<Rotate>, text_of(r.angle_deg),
                     text_of(r.axis));
}
std::string text_of(const Scale& s) {
  return fmt::format("{} {}", transform_word<Scale>, text_of(s.by));
}
std::string text_of(const Matrix& matrix) {
  std::string text(transform_word<Matrix>);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += (column == 0 && row != 0 ? " / " : " ") + text_of(matrix.m()[column][row]);
    }
  }
  return text;
}
std::string text_of(const std::vector<Transform>& transforms) {
  std::string text;
  for (const Transform& transform : transforms) {
    text += text.empty() ? "" : ", ";
    text += std::visit([](const auto& map) { return text_of(map); }, transform.map);
  }
  return text;
}

enum class Listing { others, all };

// Collects the values that differ from the default, or all values.
struct Lister {
  Listing listing = Listing::others;
  Values values = {};

  template <typename T>
  void add(std::string_view name, const T& value, const T& standard) {
    if (listing == Listing::all || !(value == standard)) {
      values.push_back({name, text_of(value)});
    }
  }
};

template <typename Owner, std::size_t N>
void list_rows(Lister& to, const ValueRow<Owner> (&rows)[N], const Owner& owner) {
  static const Owner standard;
  for (const ValueRow<Owner>& row : rows) {
    std::visit(
        [&](const auto& member) {
          if constexpr (!std::is_same_v<decltype(member), const std::monostate&>) {
            to.add(row.name(), owner.*member, standard.*member);
          }
        },
        row.member);
  }
}

void list(Lister& to, const Global& global) {
  list_rows(to, global_rows, global);
}

void list(Lister& to, const Camera& camera) {
  list_rows(to, camera_rows, camera);
}

void list(Lister& to, const Light& light) {
  to.values.push_back({"type", std::string(light_type_name(light.type))});
  list_rows(to, light_rows, light);
}

void list(Lister& to, const Primitive& primitive) {
  to.values.push_back({"type", std::string(word_of(primitive.shape))});
  to.add("file", primitive.mesh_file.str(), std::string());
  list_rows(to, material_rows, primitive.material);
}

template <typename Item>
Values listed(const Item& item, Listing listing = Listing::others) {
  Lister lister{listing};
  list(lister, item);
  return std::move(lister.values);
}

}  // namespace

Values values_of(const Global& global) {
  return listed(global);
}
Values values_of(const Camera& camera) {
  return listed(camera);
}
Values values_of(const Light& light) {
  return listed(light);
}
Values values_of(const Primitive& primitive) {
  return listed(primitive);
}

Values values_of(const Node& node) {
  Lister to;
  to.add("name", node.name.str(), std::string());
  to.add("instance of", node.instance_of.str(), std::string());
  if (!node.transforms.empty()) {
    to.values.push_back({"transforms", text_of(node.transforms)});
  }
  return std::move(to.values);
}

std::string default_text(std::string_view name) {
  static const Values parts[] = {listed(Global(), Listing::all), listed(Camera(), Listing::all),
                                 listed(Light(), Listing::all), listed(Primitive(), Listing::all)};
  for (const Values& values : parts) {
    for (const Value& value : values) {
      if (value.name == name) {
        return value.text;
      }
    }
  }
  return "none";
}

}  // namespace scenefile
