#pragma once
// Writes a JSON document. Escapes all characters outside ASCII, so that input cannot control a
// terminal; bytes that are not UTF-8 become U+FFFD.

#include <glm/glm.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <ranges>
#include <string>
#include <string_view>

namespace scenefile {

class Json;

/// A member of an object: its name, and anything that Json::value() takes.
struct JsonField {
  template <typename T>
  JsonField(std::string_view member, const T& given)
      : name(member), value(&given), write(&write_as<T>) {}

  std::string_view name;
  const void* value;  ///< must live as long as the field
  void (*write)(Json& json, const void* value);

 private:
  template <typename T>
  static void write_as(Json& json, const void* value);
};

class Json {
 public:
  Json();
  ~Json();

  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(bool b);
  void value(std::unsigned_integral auto n) { write_unsigned(n); }
  void value(std::signed_integral auto n) { write_signed(n); }
  /// NaN and infinity become null.
  void value(std::floating_point auto d) { write_number(static_cast<double>(d)); }
  template <glm::length_t n, typename T, glm::qualifier Q>
  void value(const glm::vec<n, T, Q>& v) {
    begin_array();
    for (glm::length_t i = 0; i < n; ++i) {
      value(v[i]);
    }
    end_array();
  }
  /// An array of the elements.
  template <std::ranges::range Range>
  requires(!std::convertible_to<Range, std::string_view>) void value(const Range& range) {
    begin_array();
    for (const auto& element : range) {
      value(element);
    }
    end_array();
  }

  void key(std::string_view name);
  /// Key and value in one call.
  template <typename T>
  void add(std::string_view name, const T& v) {
    key(name);
    value(v);
  }
  void add(std::initializer_list<JsonField> fields) {
    for (const JsonField& field : fields) {
      key(field.name);
      field.write(*this, field.value);
    }
  }
  /// A member with an array of objects, whose members `add_members` adds.
  template <std::ranges::range Range, typename AddMembers>
  void add_objects(std::string_view name, const Range& range, AddMembers add_members) {
    begin_array(name);
    for (const auto& element : range) {
      begin_object();
      add_members(element);
      end_object();
    }
    end_array();
  }
  void add_object(std::string_view name, std::initializer_list<JsonField> fields) {
    begin_object(name);
    add(fields);
    end_object();
  }
  /// A value that is already JSON.
  void raw(std::string_view json);

  void begin_object();
  void begin_object(std::string_view name);
  void end_object();
  void begin_array();
  void begin_array(std::string_view name);
  void end_array();

  /// The document. All objects and arrays must have been ended.
  std::string text() const;

 private:
  void write_unsigned(std::uint64_t n);
  void write_signed(std::int64_t n);
  void write_number(double d);

  struct Library;
  std::unique_ptr<Library> library_;
};

template <typename T>
void JsonField::write_as(Json& json, const void* value) {
  json.value(*static_cast<const T*>(value));
}

}  // namespace scenefile
