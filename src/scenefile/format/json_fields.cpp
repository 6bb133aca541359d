#include "scenefile/format/json_fields.h"

#include "scenefile/base/number.h"
#include "scenefile/base/suggest.h"
#include "scenefile/base/text.h"
#include "scenefile/format/codes.h"
#include "scenefile/format/foreign_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace scenefile {

namespace {

std::size_t count_elements(const JsonTape& tape, JsonIndex array) {
  std::size_t count = 0;
  for (JsonIndex i = array + 1; i < tape.end(array); i = tape.end(i)) {
    ++count;
  }
  return count;
}

// The first element that is not a number; the end of the array if all are.
JsonIndex first_other(const JsonTape& tape, JsonIndex array) {
  JsonIndex i = array + 1;
  while (i < tape.end(array) && tape.is_number(i)) {
    i = tape.end(i);
  }
  return i;
}

bool all_numbers(const JsonTape& tape, JsonIndex array) {
  return first_other(tape, array) == tape.end(array);
}

std::string key_name(const JsonContext& context, JsonIndex key) {
  return quoted(context.tape.string(key));
}

// Converts a number; reports it if it does not fit a float. Returns false also if an error was
// reported before.
bool convert(JsonContext& context, JsonIndex key, JsonIndex item, float& out) {
  if (context.repaired.is_unknown(context.tape.items[item].offset)) {
    return false;
  }
  const std::string_view text = context.tape.raw(item);
  const ParsedNumber number = parse_number(text);
  if (number.error != NumberError::none) {
    context.report(
        "json.number-range"_code, item,
        fmt::format("the number {} of {} is too large", quoted(text), key_name(context, key)));
    return false;
  }
  out = static_cast<float>(number.value);
  if (underflows(text, out)) {
    context.report("json.number-underflow"_code, item,
                   fmt::format("the number {} of {} is too small to be represented; it counts as 0",
                               quoted(text), key_name(context, key)));
  }
  return true;
}

// The number that a string was meant to be; empty for other values.
std::string number_in_quotes(const JsonTape& tape, JsonIndex item) {
  const std::string text = tape.is_string(item) ? tape.string(item) : std::string();
  const ParsedNumber number = parse_number(text);
  return number.error == NumberError::none ? number_text(static_cast<float>(number.value))
                                           : nearest_number(text);
}

// Reports, at `place`, a value that should be a number or consist of numbers.
void report_no_number(JsonContext& context, JsonIndex place, JsonIndex item,
                      std::string_view message) {
  const std::string meant = number_in_quotes(context.tape, item);
  context.report("json.wrong-type"_code, place,
                 meant.empty() ? std::string(message) : fmt::format("{}; write {}", message, meant),
                 number_correction(context.tape.string(item), meant));
}

std::string type_message(const JsonContext& context, JsonIndex key, std::string_view expected) {
  return fmt::format("{} must be {}, found {}", key_name(context, key), expected,
                     describe_json(context.tape, key + 1));
}

// Reads an array of exactly `out.size()` numbers.
bool read_numbers(JsonContext& context, JsonIndex key, JsonIndex array, std::span<float> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!convert(context, key, array + 1 + static_cast<JsonIndex>(i), out[i])) {
      return false;
    }
  }
  return true;
}

bool holds_numbers(const JsonTape& tape, JsonIndex item, std::size_t count) {
  return tape.is_array(item) && tape.end(item) - item - 1 == count && all_numbers(tape, item);
}

// Returns whether the value of a key is an array of `count` numbers; reports it otherwise.
bool check_numbers(JsonContext& context, JsonIndex key, std::size_t count,
                   std::string_view expected, bool four_dimensional) {
  const JsonTape& tape = context.tape;
  const JsonIndex value = key + 1;
  if (holds_numbers(tape, value, count)) {
    return true;
  }
  if (!tape.is_array(value)) {
    report_json_type(context, key, expected);
    return false;
  }
  if (const JsonIndex other = first_other(tape, value); other != tape.end(value)) {
    report_no_number(context, other, other,
                     fmt::format("{} must be {}, found {} in it", key_name(context, key), expected,
                                 describe_json(tape, other)));
    return false;
  }
  const std::size_t found = count_elements(tape, value);
  const bool fork = four_dimensional && found == (count == 4 ? 7 : 4);
  context.report(
      fork ? "json.four-dimensional"_code : "json.wrong-length"_code, key,
      fmt::format("{} must be {}, found {} number{}{}", key_name(context, key), expected, found,
                  found == 1 ? "" : "s",
                  fork ? ": this looks like a scene of the 4-D fork, which cannot be read" : ""));
  return false;
}

std::optional<glm::vec3> read_three(JsonContext& context, JsonIndex key, std::string_view expected,
                                    bool four_dimensional) {
  float v[3];
  if (!check_numbers(context, key, 3, expected, four_dimensional) ||
      !read_numbers(context, key, key + 1, v)) {
    return std::nullopt;
  }
  return glm::vec3(v[0], v[1], v[2]);
}

}  // namespace

JsonFields::JsonFields(JsonContext& context, JsonIndex object, const JsonVocabulary& vocabulary)
    : context_(context), object_(object), vocabulary_(vocabulary) {
  const JsonTape& tape = context.tape;
  std::size_t count = 0;
  std::vector<JsonIndex> unknown;
  for (JsonIndex key = object + 1; key < tape.end(object); key = tape.end(key + 1)) {
    if (++count > context.limits.attributes) {
      context.report(
          "json.limit"_code, key,
          fmt::format("{} has more than {} keys; those from {} on were not read", vocabulary.what,
                      context.limits.attributes, quoted(tape.string(key))));
      break;
    }
    if (!add(key)) {
      unknown.push_back(key);
    }
  }
  unknown_ = unknown.size();
  for (const JsonIndex key : unknown) {
    settle_unknown(key);
  }
}

// A key that nearly matches one that the object lacks is an error, and is read as that key. Keys of
// extensions differ more.
void JsonFields::settle_unknown(JsonIndex key) {
  const std::string name = context_.tape.string(key);
  const std::string_view word = std::string_view(name).substr(0, 64);
  const std::string_view near = lacked(nearest_name(word, vocabulary_.keys));
  const std::string_view usual = lacked(translated_name(word, vocabulary_.keys));
  const std::string_view advice = json_key_advice(vocabulary_.what, word);
  const std::string_view meant = near.empty() ? usual : near;
  context_.report(
      near.empty() ? "json.unknown-key"_code : "json.misspelled-key"_code, key,
      fmt::format("unknown key {} in {}{}{}", quoted(name), vocabulary_.what,
                  near.empty() ? " is ignored" : "",
                  !meant.empty()    ? fmt::format("; did you mean \"{}\"?", meant)
                  : !advice.empty() ? fmt::format("; {}", advice)
                                    : ""),
      correction(word, meant, near.empty() ? std::vector<std::string_view>() : missing()));
  if (!near.empty()) {
    keys_[place_of(near)] = key;
  }
}

std::size_t JsonFields::place_of(std::string_view name) const {
  const auto known = std::find(vocabulary_.keys.begin(), vocabulary_.keys.end(), name);
  return static_cast<std::size_t>(known - vocabulary_.keys.begin());
}

// The name, unless the object already has that key or the vocabulary does not.
std::string_view JsonFields::lacked(std::string_view name) const {
  return name.empty() || has(place_of(name)) ? std::string_view() : name;
}

std::vector<std::string_view> JsonFields::missing() const {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < vocabulary_.keys.size(); ++i) {
    if (!has(i)) {
      names.push_back(vocabulary_.keys[i]);
    }
  }
  return names;
}

// Returns false if the vocabulary does not have the key.
bool JsonFields::add(JsonIndex key) {
  std::string_view name = context_.tape.raw(key);
  std::string decoded;
  if (name.find('\\') != std::string_view::npos) {
    decoded = context_.tape.string(key);
    name = decoded;
  }
  const std::size_t place = place_of(name);
  if (place == vocabulary_.keys.size()) {
    return false;
  }
  JsonIndex& slot = keys_[place];
  if (slot != 0) {
    const std::uint32_t first = context_.place(slot).line;
    context_.report("json.duplicate-key"_code, key,
                    fmt::format("{} occurs twice in {}, first at line {}; the last one counts",
                                quoted(name), vocabulary_.what, first));
  }
  slot = key;
  return true;
}

bool JsonFields::require(std::size_t key) const {
  if (has(key)) {
    return true;
  }
  context_.report(
      "json.missing-key"_code, object_,
      fmt::format("{} must have the key \"{}\"", vocabulary_.what, vocabulary_.keys[key]));
  return false;
}

std::string describe_json(const JsonTape& tape, JsonIndex value) {
  switch (tape.first_character(value)) {
    case '{':
      return "an object";
    case '[': {
      const std::size_t count = count_elements(tape, value);
      const bool numbers = count != 0 && all_numbers(tape, value);
      return "an array of " + counted(count, numbers ? "number" : "value");
    }
    case '"':
      return "the string " + quoted(tape.string(value));
    case 't':
    case 'f':
    case 'n':
      return std::string(tape.raw(value));
    default:
      return fmt::format("the number {}", escaped(tape.raw(value), 40));
  }
}

void report_json_type(JsonContext& context, JsonIndex key, std::string_view expected) {
  context.report("json.wrong-type"_code, key, type_message(context, key, expected));
}

std::optional<float> number_value(JsonContext& context, JsonIndex key) {
  if (!context.tape.is_number(key + 1)) {
    report_no_number(context, key, key + 1, type_message(context, key, "a number"));
    return std::nullopt;
  }
  float value = 0;
  return convert(context, key, key + 1, value) ? std::optional(value) : std::nullopt;
}

std::optional<std::string> text_value(JsonContext& context, JsonIndex key,
                                      std::uint32_t max_bytes) {
  if (!context.tape.is_string(key + 1)) {
    report_json_type(context, key, "a string");
    return std::nullopt;
  }
  if (context.tape.raw(key + 1).size() > max_bytes) {
    context.report("json.limit"_code, key,
                   fmt::format("the string of {} is longer than the limit of {} bytes",
                               key_name(context, key), max_bytes));
    return std::nullopt;
  }
  return context.tape.string(key + 1);
}

std::optional<glm::vec3> vector_value(JsonContext& context, JsonIndex key) {
  return read_three(context, key, "an array of 3 numbers (x, y, z)", true);
}

std::optional<glm::vec3> color_value(JsonContext& context, JsonIndex key) {
  return read_three(context, key, "an array of 3 numbers (red, green, blue)", false);
}

std::optional<glm::vec4> rotation_value(JsonContext& context, JsonIndex key) {
  float v[4];
  if (!check_numbers(context, key, 4, "an array of 4 numbers (axis x, y, z and degrees)", true) ||
      !read_numbers(context, key, key + 1, v)) {
    return std::nullopt;
  }
  return glm::vec4(v[0], v[1], v[2], v[3]);
}

std::optional<glm::mat4> matrix_value(JsonContext& context, JsonIndex key) {
  constexpr std::string_view expected = "4 rows, each an array of 4 numbers";
  const JsonTape& tape = context.tape;
  if (!tape.is_array(key + 1)) {
    report_json_type(context, key, expected);
    return std::nullopt;
  }
  const bool rows_fit = [&] {
    for (JsonIndex row = key + 2; row < tape.end(key + 1); row = tape.end(row)) {
      if (!holds_numbers(tape, row, 4)) {
        return false;
      }
    }
    return count_elements(tape, key + 1) == 4;
  }();
  if (!rows_fit) {
    context.report("json.wrong-length"_code, key,
                   fmt::format("{} must be {}, found {}", key_name(context, key), expected,
                               describe_json(tape, key + 1)));
    return std::nullopt;
  }
  glm::mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    float v[4];
    if (!read_numbers(context, key, key + 2 + static_cast<JsonIndex>(5 * row), v)) {
      return std::nullopt;
    }
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = v[column];
    }
  }
  return matrix;
}

bool is_json_list(JsonContext& context, JsonIndex key, std::string_view of_what) {
  if (context.tape.is_array(key + 1)) {
    return true;
  }
  report_json_type(context, key, fmt::format("an array of {}", of_what));
  return false;
}

}  // namespace scenefile
