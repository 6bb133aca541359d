#pragma once
// Internal to io: the temporary files of writes in progress, for the signal handler.

#include <string>

namespace scenefile {

/// The name of a file that is removed again, by the destructor or by a signal that ends the
/// process, unless kept. A signal finds the first 64 of those that exist at a time.
class Temporary {
 public:
  Temporary() = default;
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  /// Chooses a unique, unpredictable name in `folder`, of a file that the caller creates. Once.
  void choose(const std::string& folder);
  /// Empty until then.
  const std::string& path() const { return path_; }
  /// Call after the file got its final name.
  void keep();

 private:
  std::string path_;
  int slot_ = -1;  // -1: a signal does not find it
  bool kept_ = false;
};

/// Removes all such files. Async-signal-safe.
void remove_temporaries();

}  // namespace scenefile
