#include "scenefile/viewer/save_view.h"

#include "scenefile/format/edit_camera.h"
#include "scenefile/io/file.h"

namespace scenefile::viewer {

namespace {

// Why the file must not be overwritten; empty if it may. `now`: its contents.
std::string refusal(const std::string& path, std::string_view known, const ReadOptions& options,
                    std::string& now) {
  if (path == "-") {
    return "the scene came from standard input and has no file";
  }
  if (const IoError error = read_file(path, options.limits.file_bytes, now); !error.empty()) {
    return error.text;
  }
  return now == known ? "" : "the file has changed since it was read; look at it first";
}

}  // namespace

SavedView save_view(const std::string& path, std::string_view known, const Camera& camera,
                    const ReadOptions& options) {
  std::string now;
  if (std::string refused = refusal(path, known, options, now); !refused.empty()) {
    return {{}, std::move(refused)};
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

SavedView restore_text(const std::string& path, std::string_view known, const std::string& before,
                       const ReadOptions& options) {
  std::string now;
  if (std::string refused = refusal(path, known, options, now); !refused.empty()) {
    return {{}, std::move(refused)};
  }
  if (const IoError error = write_file(path, before); !error.empty()) {
    return {{}, error.text};
  }
  return {before, {}};
}

}  // namespace scenefile::viewer
