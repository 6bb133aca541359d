#pragma once
// Storage for members that few objects have.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace scenefile {

/// Like std::optional, but the value is stored on the heap, so that an empty one takes a single
/// pointer. For large, rarely used members of types that exist a million times.
template <typename T>
class Rare {
 public:
  Rare() = default;
  Rare(T value) : at_(std::make_unique<T>(std::move(value))) {}
  Rare(const Rare& other) : at_(other ? std::make_unique<T>(*other) : nullptr) {}
  Rare(Rare&&) noexcept = default;
  Rare& operator=(const Rare& other) { return *this = Rare(other); }
  Rare& operator=(Rare&&) noexcept = default;

  /// Replaces the value.
  template <typename... Arguments>
  T& emplace(Arguments&&... arguments) {
    at_ = std::make_unique<T>(T{std::forward<Arguments>(arguments)...});
    return *at_;
  }

  explicit operator bool() const { return at_ != nullptr; }
  bool has_value() const { return at_ != nullptr; }
  T& operator*() { return *at_; }
  const T& operator*() const { return *at_; }
  T* operator->() { return at_.get(); }
  const T* operator->() const { return at_.get(); }

  /// Compares the values; empty equals only empty.
  friend bool operator==(const Rare& a, const Rare& b) {
    return a && b ? *a == *b : a.has_value() == b.has_value();
  }

 private:
  std::unique_ptr<T> at_;
};

/// A text that is usually empty; an empty one takes a single pointer.
class RareText {
 public:
  RareText() = default;
  RareText(std::string text)
      : at_(text.empty() ? Rare<std::string>() : Rare<std::string>(std::move(text))) {}
  RareText(std::string_view text) : RareText(std::string(text)) {}
  RareText(const char* text) : RareText(std::string(text)) {}

  bool empty() const { return !at_; }
  std::size_t size() const { return str().size(); }
  const std::string& str() const {
    static const std::string none;
    return at_ ? *at_ : none;
  }
  operator const std::string&() const { return str(); }
  operator std::string_view() const { return str(); }
  void clear() { at_ = {}; }

  friend bool operator==(const RareText& a, const RareText& b) { return a.str() == b.str(); }
  friend bool operator==(const RareText& a, std::string_view b) { return a.str() == b; }
  friend bool operator==(const RareText& a, const std::string& b) { return a.str() == b; }
  friend bool operator==(const RareText& a, const char* b) { return a.str() == b; }

 private:
  Rare<std::string> at_;  // never holds an empty string
};

}  // namespace scenefile
