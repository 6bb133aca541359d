// Says what the program finds in pictures of one scene, of which the truth is drawn only once:
// scenefile_ask_path SCENE SECONDS PICTURE...

#include "scenefile/noise/judge_path.h"
#include "scenefile/verbs/compare_paths.h"
#include "scenefile/verbs/load_file.h"

#include <cstdio>
#include <cstdlib>

namespace {

using namespace scenefile;

std::string answer_of(const char* file, const PathVerdict& verdict) {
  Json json;
  json.begin_object();
  json.add("file", file);
  add_path_verdict(json, verdict);
  json.end_object();
  std::string text = json.text();
  std::erase(text, '\n');
  return text;
}

}  // namespace

int main(int count, char** words) {
  if (count < 4) {
    return 2;
  }
  LoadSettings settings;
  settings.materials = true;
  const LoadedScene scene = load_scene_file(words[1], settings);
  if (!scene.usable()) {
    return 1;
  }
  const double seconds = std::atof(words[2]);
  RenderOptions options = default_options(Profile::fine);
  options.mode = Mode::path;
  options.max_depth = path_max_depth;
  options.seed = 4711;
  PathTruth truth;
  for (int i = 3; i < count; ++i) {
    const Result<DecodedPicture> picture = load_picture_file(words[i]);
    if (!picture) {
      return 3;
    }
    if (truth.samples == 0) {
      options.width = picture->texture.width;
      options.height = picture->texture.height;
      if (draw_truth(scene, options, seconds, {}, truth) != RenderStatus::complete) {
        return 4;
      }
    }
    PathVerdict verdict;
    if (judge_by_truth(scene, options, seconds, {}, *picture, truth, verdict) !=
        RenderStatus::complete) {
      return 4;
    }
    std::printf("%s\n", answer_of(words[i], verdict).c_str());
  }
  return 0;
}
