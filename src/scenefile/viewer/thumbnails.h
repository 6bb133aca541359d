#pragma once
// Small pictures of scene files, traced one after another on another thread.

#include "scenefile/asset/image.h"
#include "scenefile/io/folder.h"
#include "scenefile/viewer/background.h"
#include "scenefile/viewer/opened_scene.h"

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace scenefile::viewer {

inline constexpr int thumbnail_width = 128;
inline constexpr int thumbnail_height = 96;
/// A picture that takes longer to trace, in seconds, is kept as coarse as it is at that time.
inline constexpr double thumbnail_seconds = 1.5;
/// Larger files, in bytes, get no thumbnail: reading them would delay the others.
inline constexpr std::uint64_t thumbnail_file_bytes = std::uint64_t{8} << 20;

struct Thumbnail {
  FileStamp stamp;    ///< of the file
  Texture picture;    ///< empty: there is none
  std::string wrong;  ///< why there is none, one line
};

/// Traces a thumbnail until `go_on` returns false.
Thumbnail make_thumbnail(const LoadScene& load, const std::string& path,
                         const std::function<bool()>& go_on);

/// Must be used from one thread.
class Thumbnails {
 public:
  ~Thumbnails() { stop(); }

  /// The thumbnail of a file; null if it does not exist yet: then it is requested, and tick()
  /// starts it.
  const Thumbnail* find(const std::string& path);

  /// Takes a finished thumbnail, and starts the first of those requested since the last call.
  /// Returns true if there is a new one.
  bool tick(const LoadScene& load, const std::function<void()>& wake);

  bool busy() const { return job_.busy() || !wanted_.empty(); }

  /// Ends the current work early, and drops all requests. Does not wait.
  void stop();

  /// Forgets thumbnails of files that have changed.
  void check_files();

  const std::map<std::string, Thumbnail>& all() const { return known_; }

 private:
  std::map<std::string, Thumbnail> known_;
  std::vector<std::string> wanted_;
  std::string path_;  ///< of the current job
  std::shared_ptr<std::atomic<bool>> stopped_;
  Background<Thumbnail> job_;
};

}  // namespace scenefile::viewer
