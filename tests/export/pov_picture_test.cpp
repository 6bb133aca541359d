// POV-Ray draws exported scenes like the tracer does.

#include "scenefile/asset/compare_images.h"
#include "scenefile/asset/image_file.h"
#include "scenefile/export/write_pov.h"
#include "scenefile/io/file.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace scenefile {
namespace {

namespace fs = std::filesystem;
using trace_test::rotate;
using trace_test::scale;
using trace_test::SceneBuilder;
using trace_test::translate;

constexpr int width = 200;
constexpr int height = 150;

// Different in every corner, to detect flipped or rotated images.
Texture compass() {
  Texture t;
  t.width = t.height = 64;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const int checker = (x / 16 + y / 16) % 2;
      t.rgb.insert(t.rgb.end(),
                   {std::uint8_t(x * 4), std::uint8_t(y * 4), std::uint8_t(checker * 255)});
    }
  }
  return t;
}

class PovPicture : public testing::Test {
 protected:
  PovPicture() : folder_(fs::path(testing::TempDir()) / ("pov" + std::to_string(getpid()))) {
    fs::create_directory(folder_);
    scene_.look({1.5, 2.5, 5}, {0, 0, 0}, 45);
    options_.transparent = 0;
  }
  ~PovPicture() override { fs::remove_all(folder_); }

  std::uint32_t textured(float blend, float repeat) {
    RenderMaterial m;
    m.blend = blend;
    m.texture = {static_cast<std::uint32_t>(scene_.assets.textures.size()), repeat, repeat};
    scene_.assets.textures.push_back(compass());
    scene_.assets.textures.back().format = "PNG";
    const std::string path = (folder_ / "compass.png").string();
    const std::string png =
        *encode_image(to_float(compass()), ImageFormat::png8, Rounding::nearest);
    EXPECT_EQ(error_text(write_file(path, png)), "");
    scene_.scene.texture_files.push_back({"compass.png", {}});
    paths_.push_back(path);
    return scene_.material(m);
  }

  Texture ours() const {
    RenderOptions o = default_options(Profile::fine);
    o.samples = 1;
    o.features.texture_filter = false;
    return quantize(scene_.picture(width, height, o), Rounding::nearest);
  }

  Texture theirs() {
    Diagnostics diagnostics;
    const std::string pov = write_pov(scene_.scene, scene_.assets, paths_, options_, diagnostics);
    EXPECT_EQ(error_text(write_file((folder_ / "scene.pov").string(), pov)), "");
    const std::string command = "cd '" + folder_.string() +
                                "' && '" POVRAY "' +Iscene.pov +Oscene.png +W" +
                                std::to_string(width) + " +H" + std::to_string(height) +
                                " -A -D +WT1 File_Gamma=1.0 > log.txt 2>&1";
    if (std::system(command.c_str()) != 0) {
      const Result<std::string> log = read_file((folder_ / "log.txt").string(), 1 << 20);
      ADD_FAILURE() << (log ? *log : log.error().text);
      return {};
    }
    const Result<std::string> png = read_file((folder_ / "scene.png").string(), 1 << 24);
    if (!png) {
      ADD_FAILURE() << png.error().text;
      return {};
    }
    const Limits limits;
    return *decode_image(*png);
  }

  void expect_alike(double min_db) { EXPECT_GE(compare_images(ours(), theirs()).psnr_db, min_db); }

  SceneBuilder scene_;
  std::vector<std::string> paths_;
  PovOptions options_;
  fs::path folder_;
};

// Most differences are single pixels at silhouettes and texel edges.
TEST_F(PovPicture, TextureCoordinatesOfEveryShape) {
  const std::uint32_t m = textured(1, 2);
  scene_.add(Shape::sphere, translate({-1.4f, .8f, 0}), m);
  scene_.add(Shape::cylinder, translate({0, .8f, 0}), m);
  scene_.add(Shape::cone, translate({1.4f, .8f, 0}), m);
  scene_.add(Shape::cube, translate({-1.4f, -.8f, 0}), m);
  scene_.add(Shape::cube, translate({0, -.8f, 0}) * rotate(150, {1, 1, 0}), m);
  scene_.add(Shape::cylinder, translate({1.4f, -.8f, 0}) * rotate(140, {1, 0, 0}), m);
  scene_.light(LightType::directional, glm::normalize(glm::vec3(-1, -2, -3)), glm::vec3(1));
  expect_alike(26);
}

TEST_F(PovPicture, PhongWithMirrorsAndShadows) {
  RenderMaterial red;
  red.ambient = {.2f, .1f, .1f};
  red.diffuse = {.7f, .2f, .2f};
  red.specular = glm::vec3(.6f);
  red.shininess = 20;
  RenderMaterial mirror;
  mirror.diffuse = glm::vec3(.3f);
  mirror.reflective = glm::vec3(.5f);
  scene_.add(Shape::sphere, translate({0, .5f, 0}) * scale({1, 2, 1}), scene_.material(red));
  scene_.add(Shape::cone, translate({-1, 0, .5f}) * rotate(30, {0, 0, 1}), scene_.material(red));
  scene_.add(Shape::cube, translate({0, -1, 0}) * scale({4, .5f, 4}), scene_.material(mirror));
  scene_.light(LightType::point, {3, 4, 2}, {.8f, .8f, .7f});
  scene_.light(LightType::directional, glm::normalize(glm::vec3(1, -2, -1)), {.2f, .2f, .3f});
  expect_alike(38);
}

TEST_F(PovPicture, FadingLight) {
  scene_.add(Shape::cube, translate({0, -1, 0}) * scale({6, .5f, 6}), scene_.material({}));
  scene_.light(LightType::point, {0, 2, 0}, glm::vec3(1)).attenuation = {1, 0, .2f};
  expect_alike(45);
}

TEST_F(PovPicture, MeshesAndInstances) {
  Mesh roof;
  roof.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 1, 0}};
  roof.triangles = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  const std::uint32_t mesh = scene_.mesh(roof);
  RenderPrimitive p = scene_.primitive(Shape::mesh, scale({.5f, 1, .5f}), scene_.material({}));
  p.mesh = mesh;
  RenderScene& s = scene_.scene;
  s.groups[0].primitives = {p};
  s.groups.emplace_back();
  for (const float x : {-1.f, 0.f, 1.f}) {
    s.groups[1].instances.push_back(
        scene_.instance(0, translate({x, 0, 0}) * rotate(40 * x, {0, 1, 0})));
  }
  s.root = 1;
  scene_.light(LightType::point, {3, 4, 5}, glm::vec3(1));
  expect_alike(38);
}

}  // namespace
}  // namespace scenefile
