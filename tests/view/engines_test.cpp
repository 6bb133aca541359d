// Both engines draw our own scenes alike.

#include "io/temp_folder.h"
#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/io/file.h"
#include "view/build_scene.h"
#include "view/two_engines.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace scenefile {

namespace {

using namespace view_test;

class BothEngines : public Drawn {
 protected:
  void expect_alike(const std::string& name) {
    expect_file_alike(std::string(SCENEFILE_SCENES) + "/" + name, name);
  }
  // Draws each object in a separate transblock, with coefficients of 0.5, seen from `distance`.
  void expect_text_alike(const std::string& lights, const std::string& objects, double distance) {
    const std::string text = fmt::format(
        R"(<scenefile><globaldata><ambientcoeff v="0.5"/><diffusecoeff v="0.5"/><specularcoeff v="0.5"/></globaldata>
<cameradata><pos x="0" y="0" z="{}"/><look x="0" y="0" z="-1"/><up x="0" y="1" z="0"/><heightangle v="45"/></cameradata>
{}<object type="tree" name="root">{}</object></scenefile>)",
        distance, lights, objects);
    expect_file_alike(folder.write("scene.xml", text), objects.substr(0, 80));
  }
  void expect_file_alike(const std::string& path, const std::string& name) {
    const testing_support::LoadedScene scene = testing_support::load_scene(path, false);
    ASSERT_EQ(scene.error, "");
    const Agreement agreement = two_engines(*device, scene, 320, 240);
    ASSERT_EQ(agreement.error, "");
    EXPECT_GE(agreement.whole_db, 32) << name;
    EXPECT_GE(agreement.inside_db, 40) << name;
  }

  testing_support::TempFolder folder;
};

const std::string sun =
    R"(<lightdata><id v="0"/><color r="1" g="1" b="1"/><type v="directional"/><direction x="-1" y="-1" z="-1"/></lightdata>)";

std::string placed(const std::string& transforms, const std::string& shape) {
  return fmt::format(
      R"(<transblock>{}<object type="primitive" name="{}"><ambient r="0.2" g="0.2" b="0.3"/><diffuse r="0.9" g="0.6" b="0.3"/><specular r="1" g="1" b="1"/><shininess v="15"/></object></transblock>)",
      transforms, shape);
}

TEST_F(BothEngines, DrawHelloAlike) {
  expect_alike("hello.xml");
}

TEST_F(BothEngines, DrawTheShowcaseAlike) {
  expect_alike("showcase.xml");
}

TEST_F(BothEngines, DrawMirroredAndStretchedShapesAlike) {
  std::string objects;
  int column = 0;
  for (const char* const shape : {"sphere", "cube", "cone", "cylinder"}) {
    const double x = 1.3 * column++ - 2;
    objects +=
        placed(
            fmt::format(
                R"(<translate x="{}" y="0.8" z="0"/><scale x="-1" y="1" z="1"/><rotate x="1" y="1" z="0" angle="40"/>)",
                x),
            shape) +
        placed(
            fmt::format(
                R"(<translate x="{}" y="-0.8" z="0"/><rotate x="0" y="1" z="1" angle="30"/><scale x="0.3" y="1.4" z="-1"/>)",
                x),
            shape);
  }
  expect_text_alike(sun, objects, 6);
}

// Bumps that vary from texel to texel, on faces seen at an angle.
TEST_F(BothEngines, DrawBumpyFacesAlike) {
  Image bumps(400, 400);
  std::minstd_rand random(1);
  for (int y = 0; y < bumps.height; ++y) {
    for (int x = 0; x < bumps.width; ++x) {
      std::fill_n(bumps.pixel(x, y), 3, static_cast<float>(random() % 256) / 255);
    }
  }
  folder.write("bumps.png", *encode_image(bumps, ImageFormat::png8, Rounding::nearest));
  expect_text_alike(
      sun,
      R"(<transblock><rotate x="1" y="0" z="0" angle="35"/><rotate x="0" y="1" z="0" angle="45"/>
<object type="primitive" name="cube"><diffuse r="0.9" g="0.6" b="0.3"/><bumpmap file="bumps.png" u="1" v="1"/></object></transblock>)",
      3);
}

TEST_F(BothEngines, DrawGiantAndTinyScenesAlike) {
  for (const double size : {1e-4, 1e5}) {
    std::string objects;
    for (int i = 0; i < 4; ++i) {
      objects +=
          placed(fmt::format(R"(<translate x="{}" y="0" z="{}"/><scale x="{}" y="{}" z="{}"/>)",
                             (i - 1.5) * size, -i * size, size, size, size),
                 i % 2 == 0 ? "sphere" : "cylinder");
    }
    expect_text_alike(sun, objects, 5 * size);
  }
}

TEST_F(BothEngines, DrawManyLightsAndNoneAlike) {
  std::string lights;
  for (int i = 0; i < 12; ++i) {
    lights += fmt::format(
        R"(<lightdata><id v="{}"/><color r="0.{}" g="0.1" b="0.15"/><type v="point"/><position x="{}" y="{}" z="3"/></lightdata>)",
        i, 1 + i % 3, i - 6, i % 4 - 1);
  }
  const std::string objects =
      placed("", "sphere") + placed(R"(<translate x="1.2" y="0" z="0"/>)", "cone");
  expect_text_alike(lights, objects, 4);
  expect_text_alike("", objects, 4);
  expect_text_alike(sun, "", 4);
}

// Pictures of our own scenes; inspect them before accepting them with SCENEFILE_ACCEPT_GOLDEN=1.
TEST_F(BothEngines, OpenGlDrawsTheAcceptedPictures) {
  for (const char* const name : {"hello", "showcase"}) {
    const testing_support::LoadedScene scene =
        testing_support::load_scene(fmt::format("{}/{}.xml", SCENEFILE_SCENES, name), false);
    Drawing drawing = upload(*device, scene.ready.scene, scene.assets, {}, diagnostics);
    const Texture ours = quantize(
        *draw_image(*device, drawing, scene.ready.scene.camera, {}, 240, 180), Rounding::nearest);
    const std::string path = fmt::format("{}/{}-gl.png", SCENEFILE_GOLDEN, name);
    if (std::getenv("SCENEFILE_ACCEPT_GOLDEN") != nullptr) {
      const std::string png = *encode_image(to_float(ours), ImageFormat::png8, Rounding::nearest);
      ASSERT_EQ(error_text(write_file(path, png)), "");
    }
    const Limits limits;
    const Result<std::string> bytes = read_file(path, limits.file_bytes);
    ASSERT_EQ(error_text(bytes), "");
    // Other drivers place samples and round differently.
    EXPECT_GE(compare_images(ours, *decode_image(*bytes)).psnr_db, 32) << name;
  }
}

}  // namespace

}  // namespace scenefile
