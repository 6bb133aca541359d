#pragma once
// Members that most objects do without.

#include <memory>
#include <utility>

namespace scenefile {

/// As std::optional, but the value lies apart: where there is none this is one pointer long, for
/// members that are large and rare in things of which there are a million.
template <typename T>
class Rare {
 public:
  Rare() = default;
  Rare(T value) : at_(std::make_unique<T>(std::move(value))) {}
  Rare(const Rare& other) : at_(other ? std::make_unique<T>(*other) : nullptr) {}
  Rare(Rare&&) noexcept = default;
  Rare& operator=(const Rare& other) { return *this = Rare(other); }
  Rare& operator=(Rare&&) noexcept = default;

  /// The new value.
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

  /// Of the values; none equals none alone.
  friend bool operator==(const Rare& a, const Rare& b) {
    return a && b ? *a == *b : a.has_value() == b.has_value();
  }

 private:
  std::unique_ptr<T> at_;
};

}  // namespace scenefile
