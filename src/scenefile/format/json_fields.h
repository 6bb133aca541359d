#pragma once
// The building blocks of the JSON reader: keys of objects, and typed values. Everything here
// reports errors and continues. Internal to format.

#include "scenefile/base/diagnostics.h"
#include "scenefile/base/limits.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/format/json_syntax.h"
#include "scenefile/format/text_places.h"
#include "scenefile/scene/vocabulary.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

/// The state of reading a text.
struct JsonContext {
  /// `text` is the author's text; `repaired` maps offsets in the tape's text to it.
  JsonContext(const JsonTape& t, std::string_view text, const RepairedJson& r, const Limits& l,
              Diagnostics& d)
      : tape(t), repaired(r), limits(l), diagnostics(d), places(text) {}

  Location place(JsonIndex item) {
    return places.at(repaired.original_offset(tape.items[item].offset));
  }
  void report(const Code& code, JsonIndex item, std::string message,
              std::optional<Correction> correction = {}) {
    diagnostics.report(code, place(item), std::move(message), std::move(correction));
  }

  const JsonTape& tape;
  const RepairedJson& repaired;
  const Limits& limits;
  Diagnostics& diagnostics;
  TextPlaces places;
};

/// The keys of one type of object.
struct JsonVocabulary {
  std::string_view what;  ///< for messages, such as "a group"
  std::span<const std::string_view> keys;
};

/// The number of keys of the row.
template <typename Owner>
constexpr std::size_t count_keys(const ValueRow<Owner>& row) {
  return row.json.empty() ? 0 : row.json_repeat[0].key.empty() ? 1 : 3;
}

/// The index in the vocabulary of the row's first key; for row N, the total number of keys.
template <typename Owner, std::size_t N>
constexpr std::size_t key_of(const ValueRow<Owner> (&rows)[N], std::size_t row) {
  std::size_t key = 0;
  for (std::size_t i = 0; i < row; ++i) {
    key += count_keys(rows[i]);
  }
  return key;
}
template <typename Owner, std::size_t N>
constexpr std::size_t key_of(const ValueRow<Owner> (&rows)[N], Field field) {
  return key_of(rows, index_of(rows, field));
}

/// `first`, followed by the keys of the rows, in order.
template <std::size_t Count, typename Owner, std::size_t N>
constexpr std::array<std::string_view, Count> keys_of(
    const ValueRow<Owner> (&rows)[N], std::span<const std::string_view> first = {}) {
  std::array<std::string_view, Count> keys{};
  std::size_t next = 0;
  for (const std::string_view key : first) {
    keys[next++] = key;
  }
  for (const ValueRow<Owner>& row : rows) {
    if (count_keys(row) != 0) {
      keys[next++] = row.json;
    }
    if (count_keys(row) == 3) {
      keys[next++] = row.json_repeat[0].key;
      keys[next++] = row.json_repeat[1].key;
    }
  }
  return keys;
}

/// The keys of an object, by their index in the vocabulary.
class JsonFields {
 public:
  static constexpr std::size_t max_keys = 16;

  /// Reports unknown and duplicate keys. A misspelled key is an error, and then counts as the
  /// suggested one. `object` must be an object.
  JsonFields(JsonContext& context, JsonIndex object, const JsonVocabulary& vocabulary);

  bool has(std::size_t key) const { return keys_[key] != 0; }
  /// The item of the key; its value is the next item.
  JsonIndex key(std::size_t key) const { return keys_[key]; }
  std::size_t unknown() const { return unknown_; }
  /// Returns whether the object has the key; reports it as missing otherwise.
  bool require(std::size_t key) const;

 private:
  bool add(JsonIndex key);
  void settle_unknown(JsonIndex key);
  std::size_t place_of(std::string_view name) const;
  std::string_view lacked(std::string_view name) const;
  std::vector<std::string_view> missing() const;

  JsonContext& context_;
  JsonIndex object_;
  const JsonVocabulary& vocabulary_;
  std::array<JsonIndex, max_keys> keys_{};  // 0 is the document, never a key
  std::size_t unknown_ = 0;
};

/// A description for messages: "an array of 3 numbers", "the number 5", "a string".
std::string describe_json(const JsonTape& tape, JsonIndex value);

/// Reports a value of the wrong type.
void report_json_type(JsonContext& context, JsonIndex key, std::string_view expected);

// The value of a key; nullopt, and a report, if it has another type.
std::optional<float> number_value(JsonContext& context, JsonIndex key);
std::optional<std::string> text_value(JsonContext& context, JsonIndex key, std::uint32_t max_bytes);
/// A point or direction.
std::optional<glm::vec3> vector_value(JsonContext& context, JsonIndex key);
std::optional<glm::vec3> color_value(JsonContext& context, JsonIndex key);
/// x, y, z, and the angle in degrees.
std::optional<glm::vec4> rotation_value(JsonContext& context, JsonIndex key);
std::optional<glm::mat4> matrix_value(JsonContext& context, JsonIndex key);

/// The value of a key, for BlockReader.
struct WrittenJson {
  JsonContext& context;
  JsonIndex key;

  Location place() const { return context.place(key); }
  bool number(float& number) const { return store(number_value(context, key), number); }
  bool three(ValueKind kind, glm::vec3& value) const {
    return store(kind == ValueKind::color ? color_value(context, key) : vector_value(context, key),
                 value);
  }

 private:
  template <typename T>
  static bool store(const std::optional<T>& from, T& to) {
    to = from.value_or(to);
    return from.has_value();
  }
};

/// Returns whether the value is an array; reports it otherwise.
bool is_json_list(JsonContext& context, JsonIndex key, std::string_view of_what);

}  // namespace scenefile
