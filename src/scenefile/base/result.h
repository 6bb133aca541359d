#pragma once
// How everything outside of scenes reports failure: a value, or the reason why there is none.
// Defects of a scene are reported through Diagnostics (diagnostics.h); Result is for what keeps a
// scene from being read at all.
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
#include <vector>

namespace scenefile {

/// The kind of failure. Each maps to an exit status of the program, given in parentheses.
enum class ErrorKind : std::uint8_t {
  environment,  ///< cannot read or write something (3)
  limit,        ///< the input is larger than the limits allow (4)
  input,        ///< the bytes are invalid (1)
  usage,        ///< the request is invalid (2)
  cancelled,    ///< stopped at the request of the caller (130)
};

struct Error {
  std::string text;  ///< a message of one line, without the name of the program
  ErrorKind kind = ErrorKind::environment;
  std::vector<std::string> notes = {};  ///< more lines, such as the places searched
};

/// The error for invalid bytes.
inline Error input_error(std::string text) {
  return {std::move(text), ErrorKind::input};
}

/// A value or an error. Converts to true if it holds a value; only then may it be dereferenced.
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

  /// Only valid if there is no value.
  const Error& error() const {
    assert(state_.index() == 1);
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

/// Success or an error, for operations that return no value.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : failed_(true), error_(std::move(error)) {}

  explicit operator bool() const { return !failed_; }

  /// Only valid after a failure.
  const Error& error() const {
    assert(failed_);
    return error_;
  }

 private:
  bool failed_ = false;
  Error error_;
};

/// Why it failed; empty if it succeeded.
template <typename T>
std::string error_text(const Result<T>& result) {
  return result ? std::string() : result.error().text;
}

}  // namespace scenefile
