#include "scenefile/viewer/collect_views.h"

#include "scenefile/format/read_cameras.h"
#include "scenefile/io/file.h"
#include "scenefile/io/folder.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace scenefile::viewer {

namespace {

// The path in the file; without views if there is no file.
Result<CameraPath> read_views(const std::string& path, const Camera& scene, const Limits& limits) {
  if (!stamp_of(path).exists) {
    return CameraPath{};
  }
  const Result<std::string> text = read_file(path, limits.file_bytes);
  if (!text) {
    return text.error();
  }
  Result<CameraPath> views = read_cameras(*text, scene, limits);
  return views ? std::move(views)
               : Error{fmt::format("{}:{}", file_name_of(path), views.error().text)};
}

}  // namespace

std::string views_file(const std::string& scene) {
  const std::string name = scene == "-" ? "scene" : file_name_of(scene);
  return absolute_path(name.substr(0, name.rfind('.')) + "-views.json");
}

Result<std::size_t> change_views(const std::string& path, const std::optional<Camera>& added,
                                 const Camera& scene, const Limits& limits) {
  Result<CameraPath> views = read_views(path, scene, limits);
  if (!views) {
    return views.error();
  }
  std::vector<scenefile::CameraView>& all = views->views;
  if (added) {
    scenefile::CameraView view;
    view.camera = *added;
    view.time = all.empty() ? 0 : all.back().time + 1;
    all.push_back(view);
  } else if (all.empty()) {
    return Error{"there are no views"};
  } else {
    all.pop_back();
  }
  const Result<void> changed =
      all.empty() ? remove_file(path) : write_file(path, write_cameras(*views));
  return changed ? Result<std::size_t>(all.size()) : changed.error();
}

}  // namespace scenefile::viewer
