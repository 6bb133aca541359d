#pragma once
// Writes a JSON document. Escapes all characters outside ASCII, so that input cannot control a
// terminal; bytes that are not UTF-8 become U+FFFD.

#include <glm/glm.hpp>

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace scenefile {

class Json {
 public:
  Json();
  ~Json();

  void value(std::string_view text);
  void value(bool b);
  void value(std::unsigned_integral auto n) { write_unsigned(n); }
  void value(std::signed_integral auto n) { write_signed(n); }
  /// NaN and infinity become null.
  void value(std::floating_point auto d) { write_number(static_cast<double>(d)); }
  template <typename T, glm::qualifier Q>
  void value(const glm::vec<3, T, Q>& v) {
    begin_array();
    for (int i = 0; i < 3; ++i) {
      value(v[i]);
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
  void add(std::string_view name, const char* v) { add(name, std::string_view(v)); }
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

}  // namespace scenefile
