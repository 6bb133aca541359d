#pragma once
// Shared by the functions for the page (page.cpp, page_tools.cpp).

#include "answer.h"
#include "scenefile/asset/image.h"
#include "scenefile/base/realtime.h"
#include "scenefile/base/result.h"
#include "scenefile/io/file.h"
#include "scenefile/path/path_scene.h"
#include "scenefile/path/path_state.h"
#include "scenefile/trace/features.h"
#include "scenefile/trace/trace_scene.h"
#include "scenefile/verbs/load_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenefile {

inline constexpr const char* files_folder = "/files";

/// A picture of mode path in progress.
struct PathPicture {
  PathPicture(const TraceScene& traced, const RenderScene& ready, const RenderOptions& asked)
      : options(asked), scene(traced, ready, asked), state(make_path_state(asked)) {}

  RenderOptions options;
  PathScene scene;
  PathState state;
};

struct Page {
  std::string answer;
  std::vector<std::uint8_t> pixels;
  LoadedScene scene;
  int opened = 0;  ///< changes whenever `scene` does
  RenderCamera written_camera;
  std::optional<TraceScene> traced;  ///< of `scene`; built by the first picture
  std::optional<PathPicture> paths;  ///< of `scene` and its camera
};

Page& page();

inline const char* give(std::string text) {
  page().answer = std::move(text);
  return page().answer.c_str();
}

template <typename Work>
const char* answered(const Work& work) {
  return give(answer_of(work, [] {
    page().paths.reset();
    page().traced.reset();
  }));
}

inline const std::uint8_t* show(const Texture& picture) {
  std::vector<std::uint8_t>& to = page().pixels;
  to.resize(std::size_t{4} * picture.width * picture.height);
  for (std::size_t i = 0, n = to.size() / 4; i < n; ++i) {
    std::copy_n(&picture.rgb[3 * i], 3, &to[4 * i]);
    to[4 * i + 3] = 255;
  }
  return to.data();
}

inline Texture texture_of(const std::uint8_t* rgba, int width, int height) {
  Texture picture{.width = width, .height = height, .rgb = {}};
  picture.rgb.resize(std::size_t{3} * width * height);
  for (std::size_t i = 0, n = picture.rgb.size() / 3; i < n; ++i) {
    std::copy_n(rgba + 4 * i, 3, &picture.rgb[3 * i]);
  }
  return picture;
}

inline AssetAccess access_of_page() {
  return {.roots = {files_folder}};
}

inline LoadSettings load_settings(LoadDepth depth, bool compat_course, bool materials = false) {
  LoadSettings settings;
  settings.depth = depth;
  settings.materials = materials;
  settings.compat_course = compat_course;
  settings.allow_missing = true;
  return settings;
}

// The options of the page's picture. `features`: one bit each, in the order of feature_words(), or
// -1 for the profile's defaults.
inline RenderOptions picture_options(int profile, int mode, int features, int width, int height,
                                     int samples, int max_depth) {
  RenderOptions options = default_options(static_cast<Profile>(profile));
  options.mode = static_cast<Mode>(mode);
  if (features >= 0) {
    const std::span<const std::string_view> words = feature_words();
    for (std::size_t i = 0; i < words.size(); ++i) {
      *find_feature(options.features, words[i]) = ((features >> i) & 1) != 0;
    }
  }
  options.width = width;
  options.height = height;
  if (options.mode == Mode::path) {
    options.samples = path_samples;
    options.max_depth = path_max_depth;
  }
  options.samples = samples > 0 ? samples : options.samples;
  options.max_depth = max_depth >= 0 ? max_depth : options.max_depth;
  options.threads = 1;
  return in_range(options);
}

/// The settings of the profile realtime: parameter 1, parameter 2, near, far, filter, milestone.
inline RealtimeOptions realtime_options(const double* values) {
  return {.tessellation = {static_cast<int>(values[0]), static_cast<int>(values[1])},
          .near = values[2],
          .far = values[3],
          .filter = static_cast<Filter>(values[4]),
          .milestone = static_cast<Milestone>(values[5])};
}

/// Writes a file to /out, from where JavaScript reads it.
inline void write_out(const std::string& name, const std::string& bytes) {
  if (const Result<void> done = write_file("/out/" + name, bytes); !done) {
    throw std::runtime_error(done.error().text);
  }
}

}  // namespace scenefile
