// Draws every reference of the assignment Realtime and reports how close the pictures are.
//
//     scenefile_realtime FOLDER [PICTURES [FILTER]]
//
// FOLDER/references.tsv lists scene, reference, assignment, parameter1, parameter2, near, far and
// filter. PICTURES is an output folder for our pictures. FILTER selects the rows whose reference
// contains it. A row passes at 45 dB (Action: 40 dB), or if each pixel that differs by more than
// 8/255 is within one pixel of a triangle's edge; realtime.tsv lists exceptions.

#include "manifest.h"
#include "read_picture.h"
#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/view/headless.h"
#include "support/load_scene.h"
#include "view/software_realtime.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace scenefile::conformance {

namespace {

constexpr int threshold = 8;  // 1/255

struct RealtimeRow {
  std::string scene;
  std::string reference;
  RealtimeOptions options;
};

struct Measured {
  std::string error;
  ImageDifference ours;
  ImageDifference software;  // of the picture drawn without OpenGL
  long over = 0;             // pixels
  long over_inside = 0;      // those farther than a pixel from any edge
};

template <typename T, std::size_t count>
bool choose(const std::string& word, const std::array<std::string_view, count>& words, T& value) {
  const auto* const found = std::find(std::begin(words), std::end(words), word);
  value = static_cast<T>(found - std::begin(words));
  return found != std::end(words);
}

bool parse_row(const std::string& line, RealtimeRow& row) {
  std::istringstream cells(line);
  std::string milestone;
  std::string filter;
  RealtimeOptions& o = row.options;
  cells >> row.scene >> row.reference >> milestone >> o.tessellation.parameter1 >>
      o.tessellation.parameter2 >> o.near >> o.far >> filter;
  return bool(cells) && choose(milestone, milestone_words, o.milestone) &&
         choose(filter, filter_words, o.filter);
}

void save(const std::string& folder, const std::string& reference, std::string_view who,
          const Texture& picture) {
  std::string name = reference;
  std::replace(name.begin(), name.end(), '/', '_');
  const std::string bytes = *encode_image(to_float(picture), ImageFormat::png8, Rounding::nearest);
  if (const Result<void> written =
          write_file(fmt::format("{}/{}.{}.png", folder, name, who), bytes);
      !written) {
    std::fprintf(stderr, "%s\n", written.error().text.c_str());
  }
}

Texture amplified(const Texture& a, const Texture& b) {
  Texture difference = a;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    difference.rgb[i] = static_cast<std::uint8_t>(std::min(255, 8 * std::abs(a.rgb[i] - b.rgb[i])));
  }
  return difference;
}

void count_over(const Texture& a, const Texture& b, const std::vector<bool>& near_edge,
                Measured& result) {
  for (std::size_t pixel = 0; pixel < near_edge.size(); ++pixel) {
    int most = 0;
    for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c) {
      most = std::max(most, std::abs(a.rgb[c] - b.rgb[c]));
    }
    result.over += most > threshold ? 1 : 0;
    result.over_inside += most > threshold && !near_edge[pixel] ? 1 : 0;
  }
}

Measured measure(GlDevice& device, const std::string& folder, const RealtimeRow& row,
                 const std::string& pictures) {
  Measured result;
  Texture theirs;
  result.error = read_picture(folder + "/" + row.reference, theirs);
  if (!result.error.empty()) {
    return result;
  }
  testing_support::LoadedScene loaded = testing_support::load_scene(folder + "/" + row.scene, true);
  if (!loaded.error.empty()) {
    result.error = loaded.error;
    return result;
  }
  const RenderScene& scene = loaded.ready.scene;
  Drawing drawing = upload(device, scene, loaded.assets, {}, loaded.diagnostics);
  DrawOptions options;
  options.realtime = row.options;
  const Result<Image> drawn =
      draw_image(device, drawing, scene.camera, options, theirs.width, theirs.height);
  if (!drawn) {
    result.error = drawn.error().text;
    return result;
  }
  const Texture ours = quantize(*drawn, Rounding::nearest);
  const view_test::SoftwarePicture software =
      view_test::software_realtime(scene, row.options, theirs.width, theirs.height);
  result.ours = compare_images(ours, theirs, threshold);
  result.software = compare_images(software.picture, theirs, threshold);
  count_over(ours, theirs, software.near_edge, result);
  if (!pictures.empty()) {
    save(pictures, row.reference, "ours", ours);
    save(pictures, row.reference, "software", software.picture);
    save(pictures, row.reference, "difference", amplified(ours, theirs));
  }
  return result;
}

bool passes(const RealtimeRow& row, const Measured& m, const Exception* exception) {
  const double goal = exception != nullptr                         ? exception->floor_db
                      : row.options.milestone == Milestone::action ? 40
                                                                   : 45;
  return m.error.empty() &&
         (m.ours.psnr_db >= goal || (exception == nullptr && m.over_inside == 0));
}

int run(const std::string& folder, const std::string& pictures, const std::string& filter) {
  const Result<HeadlessDevice> gl = open_headless_device();
  std::string error = error_text(gl);
  std::ifstream list(folder + "/references.tsv");
  const std::vector<Exception> exceptions = read_exceptions(SCENEFILE_REALTIME_EXCEPTIONS, error);
  if (!list || !gl || !error.empty()) {
    fmt::print(stderr, "{}\n", error.empty() ? folder + "/references.tsv: cannot open" : error);
    return 3;
  }
  if (!pictures.empty()) {
    std::filesystem::create_directories(pictures);
  }
  long passed = 0;
  long total = 0;
  std::string line;
  std::getline(list, line);
  while (std::getline(list, line)) {
    RealtimeRow row;
    if (!parse_row(line, row)) {
      fmt::print(stderr, "{}/references.tsv: cannot read: {}\n", folder, line);
      return 3;
    }
    if (row.reference.find(filter) == std::string::npos) {
      continue;
    }
    const Exception* const exception = find_exception(exceptions, row.reference);
    const Measured m = measure(*gl->device, folder, row, pictures);
    const bool good = passes(row, m, exception);
    ++total;
    passed += good ? 1 : 0;
    fmt::print(
        "{:5} {:6.2f} dB  max {:3}  over 8 {:7.4f} %  {:5} pixels, {} off the edges  "
        "(software {:6.2f} dB)  {} {}\n",
        good ? (exception != nullptr ? "known" : "ok") : "MISS", m.ours.psnr_db, m.ours.max,
        100 * m.ours.share_over, m.over, m.over_inside, m.software.psnr_db, row.reference, m.error);
  }
  fmt::print("{} passed, {} failed, drawn by {}\n", passed, total - passed, gl->device->renderer());
  return passed == total && total != 0 ? 0 : 1;
}

}  // namespace

}  // namespace scenefile::conformance

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    fmt::print(stderr, "usage: scenefile_realtime FOLDER [PICTURES [FILTER]]\n");
    return 2;
  }
  return scenefile::conformance::run(argv[1], argc > 2 ? argv[2] : "", argc > 3 ? argv[3] : "");
}
