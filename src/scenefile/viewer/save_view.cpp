#include "scenefile/viewer/save_view.h"

#include "scenefile/format/edit_camera.h"
#include "scenefile/io/file.h"

namespace scenefile::viewer {

SavedView save_view(const std::string& path, std::string_view known, const Camera& camera,
                    const ReadOptions& options) {
  if (path == "-") {
    return {{}, "the scene came from standard input and has no file"};
  }
  std::string now;
  if (const IoError error = read_file(path, options.limits.file_bytes, now); !error.empty()) {
    return {{}, error.text};
  }
  if (now != known) {
    return {{}, "the file has changed since it was read; look at it first"};
  }
  CameraEdit edit = edit_camera(now, camera, options);
  if (!edit.refused.empty()) {
    return {{}, std::move(edit.refused)};
  }
  if (edit.bytes == now) {
    return {std::move(edit.bytes), {}};
  }
  if (const IoError error = write_file(path, edit.bytes); !error.empty()) {
    return {{}, error.text};
  }
  return {std::move(edit.bytes), {}};
}

}  // namespace scenefile::viewer
