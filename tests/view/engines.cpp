// Renders every scene below a folder with both engines and reports how much they differ:
//
//     scenefile_engines FOLDER [OUT]
//
// OUT is an output folder for pictures that miss a threshold. The exit status is 1 if a scene
// misses a threshold and engines.tsv gives no reason, or is below the minimum given there.

#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/view/headless.h"
#include "view/two_engines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace scenefile {

namespace {

namespace fs = std::filesystem;
using view_test::Agreement;

constexpr double whole_threshold = 32;
constexpr double inside_threshold = 40;

// A scene that is exempt from the thresholds.
struct Exception {
  std::string ending;  // of the path
  double whole_floor = 0;
  double inside_floor = 0;
  std::string cause;
};

std::vector<Exception> read_exceptions() {
  std::vector<Exception> result;
  std::ifstream file(SCENEFILE_ENGINES_EXCEPTIONS);
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    Exception e;
    if (line.empty() || line.front() == '#' || !std::getline(cells, e.ending, '\t')) {
      continue;
    }
    cells >> e.whole_floor >> e.inside_floor >> std::ws;
    std::getline(cells, e.cause);
    result.push_back(e);
  }
  return result;
}

std::vector<std::string> scenes_below(const std::string& folder) {
  std::vector<std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".xml" || extension == ".json") {
      result.push_back(entry.path());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

void save(const std::string& folder, const std::string& path, std::string_view who,
          const Image& image) {
  std::string name = path;
  std::replace(name.begin(), name.end(), '/', '_');
  const std::string bytes = *encode_image(image, ImageFormat::png8, Rounding::nearest);
  if (const Result<void> written =
          write_file(fmt::format("{}/{}.{}.png", folder, name, who), bytes);
      !written) {
    std::fprintf(stderr, "%s\n", written.error().text.c_str());
  }
}

class Comparison {
 public:
  Comparison(GlDevice& device, std::string root, std::string out)
      : device_(device), root_(std::move(root)), out_(std::move(out)) {}

  void add(const std::string& path) {
    const std::string name = fs::relative(path, root_);
    const testing_support::LoadedScene scene = testing_support::load_scene(path, true);
    if (!scene.error.empty()) {
      ++unusable_;
      return;
    }
    const Agreement agreement = view_test::two_engines(device_, scene, 640, 480);
    ++compared_;
    const bool reached = agreement.error.empty() && agreement.whole_db >= whole_threshold &&
                         agreement.inside_db >= inside_threshold;
    const std::string judgement = reached ? "" : judge_miss(name, agreement);
    reached_ += reached ? 1 : 0;
    fmt::print("{:6.2f} {:6.2f}  {}{}\n", agreement.whole_db, agreement.inside_db, name, judgement);
    if (!reached && !out_.empty() && agreement.error.empty()) {
      save(out_, name, "trace", agreement.traced);
      save(out_, name, "gl", agreement.drawn);
    }
  }

  int summary() const {
    fmt::print(
        "{} of {} scenes reach {} dB whole and {} dB away from outlines; {} misses are named "
        "in engines.tsv, {} are not; {} scenes cannot be read\n",
        reached_, compared_, whole_threshold, inside_threshold, named_, unnamed_, unusable_);
    return unnamed_ == 0 ? 0 : 1;
  }

 private:
  std::string judge_miss(const std::string& name, const Agreement& agreement) {
    const auto found = std::find_if(exceptions_.begin(), exceptions_.end(),
                                    [&](const Exception& e) { return name.ends_with(e.ending); });
    if (found != exceptions_.end() && agreement.error.empty() &&
        agreement.whole_db >= found->whole_floor && agreement.inside_db >= found->inside_floor) {
      ++named_;
      return fmt::format("  miss: {}", found->cause);
    }
    ++unnamed_;
    return fmt::format("  MISS without a name {}", agreement.error);
  }

  GlDevice& device_;
  std::string root_;
  std::string out_;
  std::vector<Exception> exceptions_ = read_exceptions();
  int compared_ = 0;
  int reached_ = 0;
  int named_ = 0;
  int unnamed_ = 0;
  int unusable_ = 0;
};

int run(const std::string& folder, const std::string& out) {
  const Result<HeadlessDevice> gl = open_headless_device();
  if (!gl) {
    fmt::print(stderr, "scenefile_engines: {}\n", gl.error().text);
    return 3;
  }
  if (!out.empty()) {
    fs::create_directories(out);
  }
  Comparison comparison(*gl->device, folder, out);
  for (const std::string& path : scenes_below(folder)) {
    comparison.add(path);
  }
  return comparison.summary();
}

}  // namespace

}  // namespace scenefile

int main(int count, char** words) {
  if (count < 2 || count > 3) {
    fmt::print(stderr, "usage: scenefile_engines FOLDER [OUT]\n");
    return 2;
  }
  return scenefile::run(words[1], count > 2 ? words[2] : "");
}
