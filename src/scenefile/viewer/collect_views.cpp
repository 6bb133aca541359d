#include "scenefile/viewer/collect_views.h"

#include "scenefile/format/read_cameras.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <utility>

namespace scenefile::viewer {

namespace {

// The path in the file; without views if there is no file.
Result<CameraPath> read_views(const std::string& path, const Limits& limits) {
  if (!stamp_of(path).exists) {
    return CameraPath{};
  }
  const Result<std::string> text = read_file(path, limits.file_bytes);
  if (!text) {
    return text.error();
  }
  Result<CameraPath> views = read_cameras(*text, Camera{}, limits);
  return views ? std::move(views)
               : Error{fmt::format("{}:{}", file_name_of(path), views.error().text)};
}

// Returns the number of views.
Result<std::size_t> write_views(const std::string& path, const CameraPath& views) {
  const Result<void> written = write_file(path, write_cameras(views));
  return written ? Result<std::size_t>(views.views.size()) : written.error();
}

}  // namespace

std::string views_file(const std::string& scene) {
  const std::string name = scene == "-" ? "scene" : file_name_of(scene);
  return absolute_path(name.substr(0, name.rfind('.')) + "-views.json");
}

Result<std::size_t> collect_view(const std::string& path, const Camera& camera,
                                 const Limits& limits) {
  Result<CameraPath> views = read_views(path, limits);
  if (!views) {
    return views.error();
  }
  scenefile::CameraView view;
  view.camera = camera;
  view.time = views->views.empty() ? 0 : views->views.back().time + 1;
  views->views.push_back(view);
  return write_views(path, *views);
}

Result<std::size_t> drop_view(const std::string& path, const Limits& limits) {
  Result<CameraPath> views = read_views(path, limits);
  if (!views) {
    return views.error();
  }
  if (views->views.empty()) {
    return Error{"there are no views"};
  }
  views->views.pop_back();
  if (!views->views.empty()) {
    return write_views(path, *views);
  }
  const Result<void> removed = remove_file(path);
  return removed ? Result<std::size_t>(0) : removed.error();
}

}  // namespace scenefile::viewer
