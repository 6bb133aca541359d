#include "scenefile/viewer/save_view.h"

#include "scenefile/format/edit_camera.h"
#include "scenefile/io/file.h"

namespace scenefile::viewer {

namespace {

// The contents of the file, if it has not changed since it was read.
Result<std::string> read_unchanged(const std::string& path, std::string_view known,
                                   const ReadOptions& options) {
  if (path == "-") {
    return Error{"the scene came from standard input and has no file"};
  }
  Result<std::string> now = read_file(path, options.limits.file_bytes);
  if (now && *now != known) {
    return Error{"the file has changed since it was read; look at it first"};
  }
  return now;
}

}  // namespace

SavedView save_view(const std::string& path, std::string_view known, const Camera& camera,
                    const ReadOptions& options) {
  const Result<std::string> now = read_unchanged(path, known, options);
  if (!now) {
    return {{}, now.error().text};
  }
  Result<std::string> edited = edit_camera(*now, camera, options);
  if (!edited) {
    return {{}, edited.error().text};
  }
  if (*edited == *now) {
    return {*std::move(edited), {}};
  }
  if (const Result<void> written = write_file(path, *edited); !written) {
    return {{}, written.error().text};
  }
  return {*std::move(edited), {}};
}

SavedView restore_text(const std::string& path, std::string_view known, const std::string& before,
                       const ReadOptions& options) {
  if (const Result<std::string> now = read_unchanged(path, known, options); !now) {
    return {{}, now.error().text};
  }
  if (const Result<void> written = write_file(path, before); !written) {
    return {{}, written.error().text};
  }
  return {before, {}};
}

}  // namespace scenefile::viewer
