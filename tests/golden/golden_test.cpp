// Small pictures of our own scenes, each inspected by a person before it was accepted. To accept
// changes: run with SCENEFILE_ACCEPT_GOLDEN=1, inspect them, and commit them separately.

#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "scenefile/path/render_path.h"
#include "scenefile/path/tone.h"
#include "scenefile/trace/render.h"
#include "support/load_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>
#include <string>

namespace scenefile {
namespace {

struct Golden {
  const char* scene;  ///< below scenes/
  const char* name;   ///< of the picture, below tests/golden/
  Profile profile;
  Mode mode;
};

// Prints the test's parameter in reports.
void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

// Other processors round and fuse operations differently, which can move an edge by a sample.
constexpr double min_db = 45;

constexpr Golden goldens[] = {
    {"showcase.xml", "showcase-fine", Profile::fine, Mode::ray},
    {"showcase.xml", "showcase-course", Profile::course, Mode::ray},
    {"showcase.xml", "showcase-normals", Profile::course, Mode::normals},
    {"showcase.xml", "showcase-intersect", Profile::fine, Mode::intersect},
    {"studio.xml", "studio-path", Profile::fine, Mode::path},
};

Texture draw(const Golden& golden) {
  const testing_support::LoadedScene loaded =
      testing_support::load_scene(std::string(SCENEFILE_SCENES "/") + golden.scene, false);
  EXPECT_EQ(loaded.error, "");
  RenderOptions options = default_options(golden.profile);
  options.mode = golden.mode;
  options.width = 240;
  options.height = 180;
  if (golden.mode == Mode::path) {
    options.width = 120;
    options.height = 90;
    options.max_depth = path_max_depth;
    const PathResult result = render_path(loaded.ready.scene, loaded.assets, options);
    EXPECT_EQ(result.status, RenderStatus::complete);
    return quantize(tone_mapped(result.image, Tone::course, 0), rounding_of(golden.profile));
  }
  const RenderResult result = render(loaded.ready.scene, loaded.assets, options);
  EXPECT_EQ(result.status, RenderStatus::complete);
  return quantize(result.image, rounding_of(golden.profile));
}

class GoldenPicture : public testing::TestWithParam<Golden> {};

TEST_P(GoldenPicture, IsAsAccepted) {
  const std::string path = std::string(SCENEFILE_GOLDEN "/") + GetParam().name + ".png";
  const Texture ours = draw(GetParam());
  if (std::getenv("SCENEFILE_ACCEPT_GOLDEN") != nullptr) {
    const Result<std::string> bytes =
        encode_image(to_float(ours), ImageFormat::png8, Rounding::nearest);
    ASSERT_EQ(error_text(bytes), "");
    ASSERT_EQ(error_text(write_file(path, *bytes)), "");
  }
  const Limits limits;
  const Result<std::string> bytes = read_file(path, limits.file_bytes);
  ASSERT_EQ(error_text(bytes), "");
  const Result<Texture> accepted = decode_image(*bytes);
  ASSERT_EQ(error_text(accepted), "");
  ASSERT_EQ(accepted->width, ours.width);
  ASSERT_EQ(accepted->height, ours.height);
  EXPECT_GE(compare_images(ours, *accepted).psnr_db, min_db);
}

INSTANTIATE_TEST_SUITE_P(Ours, GoldenPicture, testing::ValuesIn(goldens), [](const auto& i) {
  std::string name = i.param.name;
  name[name.find('-')] = '_';
  return name;
});

}  // namespace
}  // namespace scenefile
