#include "scenefile/viewer/save_view.h"

#include "scenefile/edit/edits.h"
#include "scenefile/io/file.h"

#include <utility>

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

Result<std::string> save_view(const std::string& path, std::string_view known, const Camera& camera,
                              const ReadOptions& options) {
  const Result<std::string> now = read_unchanged(path, known, options);
  if (!now) {
    return now.error();
  }
  const Result<Document> document = Document::open(*now, options);
  const Result<Edit> edit = document ? set_camera(*document, camera) : document.error();
  if (!edit || edit->changes.empty()) {
    return edit ? now : Result<std::string>(edit.error());
  }
  std::string edited = applied(*now, *edit);
  const Result<void> written = write_file(path, edited);
  return written ? Result<std::string>(std::move(edited)) : written.error();
}

Result<std::string> restore_text(const std::string& path, std::string_view known,
                                 const std::string& before, const ReadOptions& options) {
  if (const Result<std::string> now = read_unchanged(path, known, options); !now) {
    return now.error();
  }
  const Result<void> written = write_file(path, before);
  return written ? Result<std::string>(before) : written.error();
}

}  // namespace scenefile::viewer
