#pragma once
// The one way to fail outside of scenes: a value, or why there is none. What is wrong with a scene
// is said by Diagnostics (diagnostics.h); this is for what keeps a scene from being looked at.
//
//     const Result<std::string> text = read_file(path, limits.file_bytes);
//     if (!text) {
//       return text.error();
//     }
//     use(*text);

#include <cassert>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace scenefile {

/// What kind of thing went wrong. Each is an exit status of the program.
enum class ErrorKind : std::uint8_t {
  environment,  ///< something cannot be read or written (3)
  limit,        ///< the input is larger than the limits allow (4)
  input,        ///< the bytes are not what they should be (1)
};

struct Error {
  std::string text;  ///< one line for a person, without a name of the program
  ErrorKind kind = ErrorKind::environment;
};

/// A value or an error. True where there is a value; only then it may be looked at.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }

  const T& operator*() const& { return *std::get_if<0>(&state_); }
  T& operator*() & { return *std::get_if<0>(&state_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&state_)); }
  const T* operator->() const { return std::get_if<0>(&state_); }
  T* operator->() { return std::get_if<0>(&state_); }

  /// Only where there is no value.
  const Error& error() const {
    assert(state_.index() == 1);
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// Whether something could be done, where there is no value to return.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}

  explicit operator bool() const { return !failed_; }

  /// Only where it failed.
  const Error& error() const {
    assert(failed_);
    return error_;
  }

 private:
  bool failed_ = false;
  Error error_;
};

}  // namespace scenefile
