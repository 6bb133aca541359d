#include "scenefile/viewer/thumbnails.h"

#include "scenefile/path/render_path.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/render.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

namespace scenefile::viewer {

namespace {

constexpr std::size_t max_known = 512;

RenderOptions thumbnail_options() {
  RenderOptions options = default_options(Profile::fine);
  options.width = thumbnail_width;
  options.height = thumbnail_height;
  options.samples = 4;
  options.max_depth = 3;
  return options;
}

// Called by one thread at a time.
Texture trace(const OpenedScene& scene, const std::function<bool()>& go_on) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Preview preview;
  preview.interval_seconds = 0.1;
  Image newest;
  bool cancelled = false;  // the last picture then lacks what was not traced
  preview.show = [&](const Image& image) {
    if (!cancelled) {
      newest = image;
    }
  };
  const Progress progress = [&](double /*done*/) {
    cancelled = cancelled || !go_on() || seconds() >= thumbnail_seconds;
    return !cancelled;
  };
  RenderControl control;
  control.progress = progress;
  control.preview = preview;
  if (scene.lit_by_faces_only()) {
    RenderOptions options = thumbnail_options();
    options.samples = 32;
    options.max_depth = path_max_depth;
    options.denoise = true;
    const PathResult paths = render_path(scene.ready.scene, scene.assets, options,
                                         {.progress = progress, .seconds = thumbnail_seconds / 2});
    return paths.samples == 0
               ? Texture()
               : quantize(tone_mapped(paths.image, Tone::course, 0), Rounding::nearest);
  }
  const RenderResult result =
      render(scene.ready.scene, scene.assets, thumbnail_options(), std::move(control));
  switch (result.status) {
    case RenderStatus::complete:
      return quantize(result.image, Rounding::nearest);
    case RenderStatus::cancelled:
      return quantize(newest, Rounding::nearest);
    case RenderStatus::limit_reached:
    case RenderStatus::failed:
      break;
  }
  return {};
}

}  // namespace

Thumbnail make_thumbnail(const LoadScene& load, const std::string& path,
                         const std::function<bool()>& go_on) {
  Thumbnail result;
  result.stamp = stamp_of(path);
  if (!result.stamp.exists) {
    result.wrong = "the file is gone";
    return result;
  }
  if (result.stamp.size > thumbnail_file_bytes) {
    result.wrong = "a large file";
    return result;
  }
  try {
    const OpenedScene scene = load({path});
    if (!scene.usable()) {
      result.wrong = scene.unreadable.empty() ? "the file has errors" : scene.unreadable;
      return result;
    }
    result.picture = trace(scene, go_on);
    if (result.picture.empty()) {
      result.wrong = "too large for a thumbnail";
    }
  } catch (const std::bad_alloc&) {
    result.wrong = "too large for a thumbnail";
  }
  return result;
}

const Thumbnail* Thumbnails::find(const std::string& path) {
  const auto found = known_.find(path);
  if (found != known_.end()) {
    return &found->second;
  }
  if (path != path_ && std::find(wanted_.begin(), wanted_.end(), path) == wanted_.end()) {
    wanted_.push_back(path);
  }
  return nullptr;
}

bool Thumbnails::tick(const LoadScene& load, const std::function<void()>& wake) {
  bool news = false;
  if (std::optional<Thumbnail> done = job_.take()) {
    if (!*stopped_) {
      if (known_.size() >= max_known) {
        known_.clear();
      }
      known_.insert_or_assign(path_, std::move(*done));
    }
    news = true;  // also if it was stopped: the next frame requests what is visible
    path_.clear();
  }
  if (!job_.busy() && !wanted_.empty()) {
    path_ = wanted_.front();
    stopped_ = std::make_shared<std::atomic<bool>>(false);
    job_.start([load, path = path_, stopped = stopped_, wake] {
      Thumbnail thumbnail = make_thumbnail(load, path, [&] { return !*stopped; });
      wake();
      return thumbnail;
    });
  }
  wanted_.clear();  // visible thumbnails are requested again when the next frame is drawn
  return news;
}

void Thumbnails::stop() {
  wanted_.clear();
  if (stopped_ != nullptr) {
    *stopped_ = true;
  }
}

void Thumbnails::check_files() {
  std::erase_if(known_,
                [](const auto& entry) { return stamp_of(entry.first) != entry.second.stamp; });
}

}  // namespace scenefile::viewer
