// Pictures driven by the caller: passes, bands, and a reused acceleration structure.

#include "scenefile/trace/film.h"

#include "scenefile/trace/bands.h"
#include "trace/build_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scenefile::trace_test {
namespace {

// Edges, a mirror, a penumbra, and a weak lens unless `aperture` is 0.
SceneBuilder many_spheres(double aperture = 0) {
  SceneBuilder b;
  b.scene.camera.aperture = aperture;
  b.scene.camera.focal_length = 4;
  RenderMaterial mirror;
  mirror.diffuse = {0.6f, 0.5f, 0.4f};
  mirror.reflective = glm::vec3(0.5);
  const std::uint32_t m = b.material(mirror);
  b.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5.5, -4)}, m);
  for (int i = 0; i < 12; ++i) {
    b.add(Shape::sphere, translate({float(i) * 0.5f - 2, float(i % 3) * 0.4f, -4}), m);
  }
  RenderLight& light = b.light(LightType::area, {1, 4, -2}, glm::vec3(0.75));
  light.half_u = {0.5, 0, 0};
  light.half_v = {0, 0, 0.5};
  b.look({0, 1, 1}, {0, 0, -4});
  return b;
}

// Options for all kinds of pictures.
std::vector<RenderOptions> all_kinds() {
  std::vector<RenderOptions> kinds;
  for (const Profile profile : {Profile::course, Profile::fine}) {
    RenderOptions options = default_options(profile);
    options.width = 75;
    options.height = 50;
    kinds.push_back(options);
    options.samples = 1;
    options.features.super_sample = true;
    kinds.push_back(options);
    options.samples = 8;
    options.layers = {{LayerKind::depth, 0}, {LayerKind::light, 0}, {LayerKind::object_id, 0}};
    kinds.push_back(options);
    options.denoise = profile == Profile::fine;
    kinds.push_back(options);
    options.crop = PixelRegion{13, 7, 61, 44};
    kinds.push_back(options);
    options.mode = Mode::normals;
    kinds.push_back(options);
  }
  return kinds;
}

void finish(const TraceScene& traced, const SceneBuilder& b, const RenderOptions& options,
            Film& film) {
  while (!complete(film)) {
    ASSERT_EQ(render_pass(traced, b.scene, options, film), RenderStatus::complete);
  }
}

void expect_same(const Resolved& drawn, const RenderResult& expected) {
  EXPECT_EQ(drawn.image.width, expected.image.width);
  EXPECT_TRUE(drawn.image.rgb == expected.image.rgb);
  ASSERT_EQ(drawn.layers.size(), expected.layers.size());
  for (std::size_t i = 0; i < drawn.layers.size(); ++i) {
    EXPECT_EQ(drawn.layers[i].name, expected.layers[i].name);
    EXPECT_TRUE(drawn.layers[i].values == expected.layers[i].values) << drawn.layers[i].name;
  }
}

TEST(Film, PassesMakeThePicture) {
  for (const double aperture : {0.0, 0.01}) {
    const SceneBuilder b = many_spheres(aperture);
    const TraceScene traced(b.scene, b.assets);
    for (const RenderOptions& options : all_kinds()) {
      Film film = make_film(b.scene, options);
      finish(traced, b, options, film);
      expect_same(resolve(std::move(film)), render(b.scene, b.assets, options));
    }
  }
}

// The pixels of bands are those of the whole picture.
TEST(Film, BandsAreThePicture) {
  for (const double aperture : {0.0, 0.01}) {
    const SceneBuilder b = many_spheres(aperture);
    const TraceScene traced(b.scene, b.assets);
    for (const RenderOptions& options : all_kinds()) {
      const RenderResult whole = render(b.scene, b.assets, options);
      const PixelRegion region =
          options.crop.value_or(PixelRegion{0, 0, options.width, options.height});
      for (const std::uint32_t count : {1u, 2u, 3u}) {
        RenderResult drawn = whole;
        std::fill(drawn.image.rgb.begin(), drawn.image.rgb.end(), -1.0F);
        for (std::uint32_t i = count; i-- > 0;) {
          const RowRange band = share_of({0, region.height()}, i, count);
          RenderOptions of_band = options;
          of_band.crop = {region.x0, region.y0 + band.first, region.x1, region.y0 + band.end};
          const RenderResult part = render(b.scene, b.assets, of_band, {.traced = &traced});
          const auto put = [&](const std::vector<float>& from, std::vector<float>& to) {
            const std::size_t row = to.size() / static_cast<std::size_t>(region.height());
            ASSERT_EQ(from.size(), row * static_cast<std::size_t>(band.rows()));
            std::copy(from.begin(), from.end(),
                      to.begin() + static_cast<std::ptrdiff_t>(row) * band.first);
          };
          put(part.image.rgb, drawn.image.rgb);
          for (std::size_t k = 0; k < part.layers.size(); ++k) {
            put(part.layers[k].values, drawn.layers[k].values);
          }
        }
        expect_same({drawn.image, drawn.layers}, whole);
      }
    }
  }
}

TEST(Film, TheMarginIsWhatIsDrawnAround) {
  const SceneBuilder b = many_spheres();
  for (RenderOptions options : all_kinds()) {
    options.crop = PixelRegion{30, 20, 40, 30};
    const Film film = make_film(b.scene, options);
    EXPECT_EQ(margin_of(b.scene, options), 20 - film.region.y0);
    EXPECT_EQ(margin_of(b.scene, options), film.region.x1 - 40);
  }
}

TEST(Film, ShortCallsContinue) {
  const SceneBuilder b = many_spheres();
  const TraceScene traced(b.scene, b.assets);
  for (const RenderOptions& options : all_kinds()) {
    Film film = make_film(b.scene, options);
    for (int calls = 0; !complete(film) && calls < 1000; ++calls) {
      render_pass(traced, b.scene, options, film, [](double) { return false; });
    }
    expect_same(resolve(std::move(film)), render(b.scene, b.assets, options));
  }
}

TEST(Film, OneStructureServesOtherCamerasLightsMaterialsAndOptions) {
  SceneBuilder b = many_spheres();
  const TraceScene traced(b.scene, b.assets);
  for (int i = 0; i < 3; ++i) {
    b.look({float(i) - 1, 1, 1}, {0, 0, -4});
    b.scene.lights.front().color = glm::vec3(0.25f * float(i + 1));
    b.scene.materials.front().diffuse.x = 0.2f * float(i);
    for (const RenderOptions& options : all_kinds()) {
      const RenderResult kept = render(b.scene, b.assets, options, {.traced = &traced});
      const RenderResult fresh = render(b.scene, b.assets, options);
      EXPECT_TRUE(kept.image.rgb == fresh.image.rgb);
    }
  }
}

TEST(Film, AStructureThatCannotBeBuiltIsReported) {
  const SceneBuilder b = many_spheres();
  EXPECT_EQ(TraceScene(b.scene, b.assets).status(), RenderStatus::complete);
  EXPECT_GE(TraceScene(b.scene, b.assets).build_seconds(), 0);
}

}  // namespace
}  // namespace scenefile::trace_test
