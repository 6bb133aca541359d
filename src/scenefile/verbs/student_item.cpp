#include "scenefile/verbs/student_item.h"

#include "scenefile/base/base64.h"
#include "scenefile/base/number.h"
#include "scenefile/base/text.h"
#include "scenefile/format/json_parser.h"
#include "scenefile/verbs/json_writer.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace scenefile {

namespace {

template <typename T, typename Struct>
concept ConstOrNot = std::same_as<std::remove_const_t<T>, Struct>;

// member(name, value) for every member of a record. With structured bindings, a missing member is a
// compile error.
template <ConstOrNot<PictureMeasures> T, typename Member>
void visit_record(T& measures, const Member& member) {
  auto& [comparable, size, right_size, difference, linear, ssim, flip_mean, flip_max] = measures;
  auto& [psnr_db, mean, max, share_over] = difference;
  member("comparable", comparable);
  member("width", size.x), member("height", size.y);
  member("right_width", right_size.x), member("right_height", right_size.y);
  member("psnr_db", psnr_db), member("mean", mean), member("max", max);
  member("share_over", share_over), member("linear", linear), member("ssim", ssim);
  member("flip_mean", flip_mean), member("flip_max", flip_max);
}

template <ConstOrNot<Claim> T, typename Member>
void visit_record(T& claim, const Member& member) {
  auto& [cause, what, evidence, explained, said, alternatives] = claim;
  member("cause", cause), member("what", what), member("evidence", evidence);
  member("explained", explained), member("said", said);
  member("alternatives", alternatives);
}

template <ConstOrNot<PictureResult> T, typename Member>
void visit_record(T& picture, const Member& member) {
  auto& [name, verdict, measures, reasons, causes, rivals, partial, notes, png, png_file,
         fingerprint, identical, path_traced] = picture;
  member("name", name), member("verdict", verdict), member("measures", measures);
  member("reasons", reasons), member("causes", causes), member("rivals", rivals);
  member("partial", partial), member("notes", notes), member("png", png);
  member("png_file", png_file), member("fingerprint", fingerprint);
  member("identical", identical), member("path_traced", path_traced);
}

template <ConstOrNot<StudentResult> T, typename Member>
void visit_record(T& student, const Member& member) {
  auto& [name, pictures, unmatched] = student;
  member("name", name), member("pictures", pictures), member("unmatched", unmatched);
}

constexpr std::string_view base64_member = "base64";

class RecordWriter {
 public:
  void put(bool value) { json.value(value); }
  void put(double value) {
    std::isfinite(value) ? json.value(value)
                         : json.value(std::string_view(fmt::format("{}", value)));
  }
  template <std::integral T>
  void put(T value) {
    json.value(value);
  }
  template <typename T>
  requires std::is_enum_v<T>
  void put(T value) { json.value(static_cast<int>(value)); }
  void put(const std::string& text) {
    if (valid_utf8(text) == text) {
      json.value(text);
      return;
    }
    json.begin_object();
    json.add(base64_member, base64(text));
    json.end_object();
  }
  template <typename T>
  void put(const std::vector<T>& list) {
    json.begin_array();
    for (const T& item : list) {
      put(item);
    }
    json.end_array();
  }
  template <typename T>
  requires std::is_class_v<T>
  void put(const T& record) {
    json.begin_object();
    visit_record(record, [this](std::string_view name, const auto& value) {
      json.key(name);
      put(value);
    });
    json.end_object();
  }

  Json json;
};

// Reads what RecordWriter wrote. After a failure, `good` is false.
class RecordReader {
 public:
  explicit RecordReader(const JsonTape& tape) : tape_(tape) {}

  void get(JsonIndex at, bool& value) {
    const char c = tape_.first_character(at);
    good = good && (c == 't' || c == 'f');
    value = c == 't';
  }
  void get(JsonIndex at, double& value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (tape_.is_string(at)) {
      const std::string text = tape_.string(at);
      value = text == "inf" ? infinity : text == "-inf" ? -infinity : std::nan("");
      return;
    }
    const ParsedNumber number = parse_number(tape_.raw(at));
    value = number.value;
    good = good && number.error == NumberError::none;
  }
  template <std::integral T>
  void get(JsonIndex at, T& value) {
    const std::string_view text = tape_.raw(at);
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    good = good && error == std::errc() && stop == end;
  }
  void get(JsonIndex at, Verdict& verdict) { enumerator(at, verdict, Verdict::unreadable); }
  void get(JsonIndex at, Cause& cause) {
    enumerator(at, cause, static_cast<Cause>(cause_count - 1));
  }
  void get(JsonIndex at, std::string& text) {
    if (tape_.is_string(at)) {
      text = tape_.string(at);
      return;
    }
    std::string packed;
    member(at, base64_member, packed);
    const std::optional<std::string> bytes = base64_decoded(packed);
    good = good && bytes;
    text = bytes.value_or("");
  }
  template <typename T>
  void get(JsonIndex at, std::vector<T>& list) {
    good = good && tape_.is_array(at);
    list.clear();
    for (JsonIndex i = at + 1; good && i < tape_.end(at); i = tape_.end(i)) {
      get(i, list.emplace_back());
    }
  }
  template <typename T>
  requires std::is_class_v<T>
  void get(JsonIndex at, T& record) {
    visit_record(record, [&](std::string_view name, auto& value) { member(at, name, value); });
  }

  template <typename T>
  void member(JsonIndex object, std::string_view name, T& value) {
    if (good && tape_.is_object(object)) {
      for (JsonIndex key = object + 1; key < tape_.end(object); key = tape_.end(key + 1)) {
        if (tape_.raw(key) == name) {
          get(key + 1, value);
          return;
        }
      }
    }
    good = false;
  }

  bool good = true;

 private:
  template <typename Enum>
  void enumerator(JsonIndex at, Enum& value, Enum last) {
    int number = 0;
    get(at, number);
    good = good && number >= 0 && number <= static_cast<int>(last);
    value = good ? static_cast<Enum>(number) : Enum{};
  }

  const JsonTape& tape_;
};

}  // namespace

std::string encode_student(const StudentResult& student, std::string_view key) {
  RecordWriter writer;
  writer.json.begin_object();
  writer.json.add("key", key);
  writer.json.key("student");
  writer.put(student);
  writer.json.end_object();
  return writer.json.text();
}

bool decode_student(std::string_view bytes, StudentResult& student) {
  constexpr std::uint32_t deepest = 16;
  JsonTape tape;
  if (parse_json(bytes, deepest, tape).fault != JsonFault::none) {
    return false;
  }
  RecordReader reader(tape);
  reader.member(0, "student", student);
  return reader.good;
}

}  // namespace scenefile
