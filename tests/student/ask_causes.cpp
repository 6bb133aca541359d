// Names the mistakes of pictures as `diff --scene` does, and says how each was found, for
// ledger.py. Reads lines from standard input: REFERENCE, PICTURE, SCENE and a quality, separated by
// tabs. With a quality from 1 to 100, the picture becomes a JPEG before it is compared. Prints a
// line of JSON for each.

#include "scenefile/verbs/compare_pictures.h"
#include "scenefile/verbs/json_writer.h"
#include "scenefile/verbs/load_file.h"
#include "support/jpeg_bytes.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace scenefile;

const LoadedScene& scene_at(const std::string& path) {
  static std::map<std::string, LoadedScene> scenes;
  const auto known = scenes.find(path);
  return (known != scenes.end() ? known : scenes.emplace(path, load_scene_file(path)).first)
      ->second;
}

// One thread: the time is that of a processor, and others may run at the same time.
std::vector<DrawnWay> all_ways() {
  std::array profiles{default_options(Profile::course), default_options(Profile::fine)};
  for (RenderOptions& options : profiles) {
    options.threads = 1;
  }
  return possible_ways(profiles, false);
}

std::string answer(const std::array<std::string, 4>& asked) {
  const auto& [reference_path, picture_path, scene_path, quality] = asked;
  const Result<DecodedPicture> reference = load_picture_file(reference_path);
  Result<DecodedPicture> picture = load_picture_file(picture_path);
  const LoadedScene& scene = scene_at(scene_path);
  Json json;
  json.begin_object();
  if (!reference || !picture || !scene.usable()) {
    json.add("error", "an input cannot be used");
    json.end_object();
    return json.text();
  }
  CompareSettings settings;
  settings.ways = folder_first(reference_path, all_ways());
  if (const int q = std::atoi(quality.c_str()); q > 0) {
    picture = decode_picture(testing_support::jpeg_of(picture->texture, q));
    settings.lossy = true;
  }
  const std::clock_t start = std::clock();
  const PictureComparison found = compare_pictures(*reference, *picture, &scene, settings);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  add_comparison(json, found);
  json.add("route", found.causes.route);
  json.add("rays", static_cast<std::int64_t>(found.causes.rays));
  json.add("seconds", seconds);
  json.end_object();
  return json.text();
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::array<std::string, 4> words;
    std::size_t start = 0;
    for (std::string& word : words) {
      const std::size_t end = std::min(line.find('\t', start), line.size());
      word = line.substr(std::min(start, line.size()), end - std::min(start, end));
      start = end + 1;
    }
    std::string text = answer(words);
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::cout << text << std::endl;
  }
  return 0;
}
