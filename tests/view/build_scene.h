#pragma once
// Shorthand for building render scenes, and a device to draw them.

#include "scenefile/view/headless.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace scenefile::view_test {

inline Affine place(const glm::vec3& offset, float size = 1) {
  return {glm::mat3(size), offset};
}

/// A root group, coefficients of 1, and a camera at the origin that looks along -z.
struct SceneBuilder {
  RenderScene scene;
  Assets assets;

  SceneBuilder() {
    scene.global.ambient = scene.global.diffuse = scene.global.specular = 1;
    scene.global.transparent = 1;
    scene.groups.resize(1);
  }

  /// Emits light: ambient term only.
  std::uint32_t glowing(const glm::vec3& color) {
    RenderMaterial m;
    m.ambient = color;
    m.diffuse = glm::vec3(0);
    scene.materials.push_back(m);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
  }

  /// Adds to the last group, which becomes the root. Sources are numbered from 0.
  void add(Shape shape, const Affine& where, std::uint32_t material) {
    RenderPrimitive p;
    p.shape = shape;
    p.group_from_object = where;
    p.material = material;
    p.source = next_source++;
    scene.groups.back().primitives.push_back(p);
    scene.root = static_cast<std::uint32_t>(scene.groups.size() - 1);
  }

  void add_instance(std::uint32_t group, const Affine& where) {
    RenderInstance i;
    i.group = group;
    i.group_from_instance = where;
    i.source = next_source++;
    scene.groups.back().instances.push_back(i);
    scene.root = static_cast<std::uint32_t>(scene.groups.size() - 1);
  }

  std::uint32_t next_source = 0;
};

/// A context and a device, shared by all tests of a process, because creating them takes most of a
/// test's time.
struct Screen {
  Result<std::unique_ptr<HeadlessContext>> context = HeadlessContext::create();
  Result<std::unique_ptr<GlDevice>> device =
      context ? GlDevice::create((*context)->get_proc_address()) : Error{"no context"};
};

class Drawn : public ::testing::Test {
 protected:
  void SetUp() override {
    static Screen screen;
    if (!screen.context) {
      GTEST_SKIP() << screen.context.error().text;
    }
    ASSERT_EQ(error_text(screen.device), "");
    device = screen.device->get();
  }

  Drawing uploaded(const SceneBuilder& builder, const UploadOptions& options = {}) {
    return upload(*device, builder.scene, builder.assets, options, diagnostics);
  }

  Image draw_square(Drawing& drawing, const RenderCamera& camera, const DrawOptions& options,
                    int size = 32) {
    Result<Image> image = draw_image(*device, drawing, camera, options, size, size, &stats);
    EXPECT_EQ(error_text(image), "");
    return *std::move(image);
  }

  GlDevice* device = nullptr;
  Diagnostics diagnostics;
  DrawStats stats;
};

inline glm::vec3 at(const Image& image, int x, int y) {
  const float* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

}  // namespace scenefile::view_test
