// The light in pictures: formulas, and agreement of independent ways of sampling.

#include "path/rooms.h"
#include "path/statistics.h"
#include "scenefile/path/path_kernel.h"

#include <numbers>
#include <string>

namespace scenefile::path_test {
namespace {

using glm::dvec3;
using std::numbers::pi;

void expect_everywhere(const Image& image, double value, double tolerance) {
  const glm::dvec3 mean = mean_of(image);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], value, tolerance * value);
  }
}

// In a closed box with emission E and albedo r, radiance is E / (1 - r) everywhere.
TEST(PathFurnace, DiffuseWalls) {
  for (const int light_samples : {0, 1, 4}) {
    SCOPED_TRACE(light_samples);
    RenderOptions options = path_options(8, 8, 2048);
    options.light_samples = light_samples;
    options.continuation = light_samples == 4 ? 0.7 : 0;
    const PathResult r = draw(closed_box(diffuse(glm::vec3(0.5f), glm::vec3(0.25f))), options);
    expect_everywhere(r.image, 0.5, 1e-3);
    EXPECT_EQ(r.state.dropped, 0u);
  }
}

TEST(PathFurnace, MirrorWalls) {
  FaceMaterial walls = mirror(glm::vec3(0.5f));
  walls.emission = glm::vec3(0.25f);
  expect_everywhere(draw(closed_box(walls), path_options(8, 8, 2048)).image, 0.5, 1e-3);
}

// Glass changes nothing in uniform light: it neither absorbs nor scales radiance.
TEST(PathFurnace, GlassInside) {
  for (const float ior : {1.0f, 1.5f, 0.7f}) {
    Room room = closed_box(diffuse(glm::vec3(0.5f), glm::vec3(0.25f)));
    Model block;
    block.box({-0.5, -0.6, -0.8}, {0.2, 0.3, -0.2}, false, block.material(glass(ior)));
    room.add(block);
    expect_everywhere(draw(room, path_options(8, 8, 2048)).image, 0.5, 1e-3);
  }
}

// The object's own material: reflective and transparent shares, and analytic shapes.
TEST(PathFurnace, ObjectMaterials) {
  RenderMaterial m;
  m.diffuse = glm::vec3(0.2f);
  m.reflective = glm::vec3(0.1f);
  m.transparent = glm::vec3(0.7f);
  m.ior = 1.3f;
  Room room = closed_box(diffuse(glm::vec3(0.5f), glm::vec3(0.25f)));
  room.add(Shape::sphere, Affine{glm::mat3(0.8f), glm::vec3(-0.3f, 0, -0.5f)}, room.material(m));
  expect_everywhere(draw(room, path_options(8, 8, 2048)).image, 0.5, 1e-3);
}

// The glossy lobe reflects less where the horizon cuts it. Once reflected, uniform light E becomes
// E times the albedo for the direction of view.
TEST(PathFurnace, GlossyWallsReflectTheirAlbedo) {
  for (const float shininess : {0.0f, 1.0f, 20.0f, 500.0f}) {
    FaceMaterial walls = glossy(glm::vec3(0.8f), shininess);
    walls.emission = glm::vec3(0.25f);
    Room room = closed_box(walls);
    room.look({0.3, 0.2, 0.5}, {-0.4, -1, 0.1}, 1e-3);
    const dvec3 to_eye = glm::normalize(dvec3(0.3, 0.2, 0.5) - dvec3(-0.4, -1, 0.1));
    const Facing facing{{0, 1, 0}, {0, 1, 0}, to_eye, true};
    Bsdf bsdf;
    bsdf.glossy = Color(0.8f);
    bsdf.shininess = shininess;
    double albedo = 0;
    constexpr int rows = 600;
    for (int i = 0; i < rows; ++i) {
      const double up = (i + 0.5) / rows;
      for (int j = 0; j < 4 * rows; ++j) {
        const double turn = 2 * pi * (j + 0.5) / (4 * rows);
        const double out = std::sqrt(1 - up * up);
        albedo +=
            evaluate(bsdf, facing, {out * std::cos(turn), up, out * std::sin(turn)}).bsdf_cosine.x *
            2 * pi / (4.0 * rows * rows);
      }
    }
    for (const int light_samples : {0, 1}) {
      RenderOptions options = path_options(2, 2, 16384);
      options.max_depth = 1;
      options.light_samples = light_samples;
      expect_everywhere(draw(room, options).image, 0.25 * (1 + albedo), 3e-3);
    }
  }
}

// A floor under a rectangular lamp; the camera looks at the origin.
Room under_lamp(double albedo, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                float radiance) {
  Room room;
  Model model;
  const std::uint32_t white = model.material(diffuse(glm::vec3(static_cast<float>(albedo))));
  model.quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, white);
  model.quad(corner, u, v, model.material(diffuse(glm::vec3(0), glm::vec3(radiance))));
  room.add(model);
  room.look({0, 0.5, 0.5}, {0, 0, 0}, 1e-4);
  return room;
}

// Lambert's formula for the irradiance of a point by a polygon of uniform radiance.
double irradiance(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::normalize(corners[i]);
    const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
    sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
  }
  return std::abs(sum) / 2;
}

TEST(PathLight, DirectLightFollowsLambertsFormula) {
  const glm::vec3 corner(0.5f, 1, -0.5f), u(0, 0, 2), v(-1.5f, 0.5f, 0);
  const glm::dvec3 c(corner), du(u), dv(v);
  const double expected = 0.6 / pi * 3 * irradiance({c, c + du, c + du + dv, c + dv}, {0, 1, 0});
  for (const bool downward : {true, false}) {
    const Room room =
        downward ? under_lamp(0.6, corner, v, u, 3) : under_lamp(0.6, corner, u, v, 3);
    for (const int light_samples : {0, 1, 3}) {
      RenderOptions options = path_options(1, 1, 16384);
      options.light_samples = light_samples;
      options.direct_only = true;
      const double seen = draw(room, options).image.rgb[0];
      const bool faces = glm::cross(downward ? v : u, downward ? u : v).y < 0;
      if (faces) {
        EXPECT_NEAR(seen, expected, 2e-3 * expected) << light_samples;
      } else {
        EXPECT_EQ(seen, 0) << light_samples;  // lamps are black on their back
      }
    }
  }
}

// A room with a lamp 1 cm below the ceiling and a block, like the Cornell box.
Room cornell(const FaceMaterial& block_material) {
  Room room;
  Model model;
  model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse(glm::vec3(0.7f, 0.6f, 0.5f))));
  model.quad({-0.3f, 1.99f, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f},
             model.material(diffuse(glm::vec3(0.5f), glm::vec3(12, 10, 8))));
  model.box({-0.6f, 0, -0.6f}, {0, 0.9f, 0}, false, model.material(block_material));
  room.add(model);
  room.look({0, 1, 0.95}, {0, 0.9, 0}, 70);
  return room;
}

struct Estimate {
  Image image;
  std::vector<float> variances;
};

Estimate estimate(const Room& room, const RenderOptions& options) {
  PathResult r = draw(room, options);
  return {std::move(r.image), variances_of(r.state)};
}

// Compares the luminance of all pixels.
void expect_same_means(const Estimate& a, const Estimate& b, int tests) {
  const double bound = sidak_bound(tests * static_cast<int>(a.variances.size()));
  double sum = 0, variance = 0;
  for (std::size_t i = 0; i < a.variances.size(); ++i) {
    const auto bright = [&](const Image& image) {
      return luminance({image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]});
    };
    const double difference = bright(a.image) - bright(b.image);
    const double together = a.variances[i] + b.variances[i];
    EXPECT_LT(std::abs(difference), bound * std::sqrt(together) + 1e-9) << "pixel " << i;
    sum += difference;
    variance += together;
  }
  EXPECT_LT(std::abs(sum), sidak_bound(tests) * std::sqrt(variance));
}

TEST(PathLight, AllWaysOfSamplingAgree) {
  FaceMaterial both = diffuse(glm::vec3(0.3f));
  both.specular = glm::vec3(0.5f);
  both.shininess = 30;
  for (const FaceMaterial& block : {both, mirror(glm::vec3(0.9f)), glass(1.5f)}) {
    SCOPED_TRACE(block.illum);
    const Room room = cornell(block);
    RenderOptions options = path_options(8, 8, 512);
    const Estimate mis = estimate(room, options);
    options.mis = false;
    options.seed = 1;
    const Estimate lights = estimate(room, options);
    options.mis = true;
    options.light_samples = 0;
    options.samples = 2048;
    options.seed = 2;
    const Estimate surfaces = estimate(room, options);
    expect_same_means(mis, lights, 6);
    expect_same_means(mis, surfaces, 6);
  }
}

TEST(PathLight, RouletteDoesNotChangeTheMean) {
  const Room room = cornell(diffuse(glm::vec3(0.8f)));
  RenderOptions options = path_options(8, 8, 512);
  const Estimate by_throughput = estimate(room, options);
  int test = 0;
  for (const double continuation : {0.3, 0.9}) {
    options.continuation = continuation;
    options.seed = ++test;
    expect_same_means(by_throughput, estimate(room, options), 2);
  }
}

// With a constant probability, path lengths are geometric.
TEST(PathLight, RouletteIsGeometric) {
  Room room = closed_box(diffuse(glm::vec3(1)));
  RenderOptions options = path_options(1, 1, 1);
  options.continuation = 0.6;
  const TraceScene traced(room.scene, room.assets);
  const PathScene scene(traced, room.scene, options);
  constexpr int count = 20000;
  std::vector<double> counts(24);
  for (int i = 0; i < count; ++i) {
    RayCounts rays;
    // Different pixels: the samples of one are stratified, which is more even than chance.
    path_light(scene, i % 200, i / 200, 0, rays);
    counts[std::min<std::uint64_t>(rays.secondary, 23)] += 1;
  }
  std::vector<double> expected;
  for (int k = 0; k < 24; ++k) {
    expected.push_back(count * std::pow(0.6, k) * (k < 23 ? 0.4 : 1));
  }
  EXPECT_LT(std::abs(chi_square_deviate(counts, expected)), sidak_bound(1));
}

TEST(PathLight, MaxDepthCutsPaths) {
  RenderOptions options = path_options(4, 4, 512);
  options.light_samples = 0;
  double sum = 0.25;
  for (const int depth : {1, 2, 3}) {
    options.max_depth = depth;
    sum += 0.25 * std::pow(0.5, depth);
    expect_everywhere(draw(closed_box(diffuse(glm::vec3(0.5f), glm::vec3(0.25f))), options).image,
                      sum, 1e-4);  // roulette after the third bounce
  }
}

// The lamp seen through a mirror is part of direct_only, light from a lit wall is not.
TEST(PathLight, DirectOnlyIncludesMirrors) {
  Room room;
  Model model;
  model.quad({-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, model.material(mirror(glm::vec3(0.5f))));
  model.quad({1, -1, 1}, {-2, 0, 0}, {0, 2, 0},
             model.material(diffuse(glm::vec3(0), glm::vec3(3))));
  room.add(model);
  room.look({0, 0, 0}, {0, 0, -1}, 10);
  RenderOptions options = path_options(2, 2, 16);
  options.direct_only = true;
  expect_everywhere(draw(room, options).image, 1.5, 1e-6);
}

// Faces that lie in one plane, also with the opposite winding, do not shadow each other.
TEST(PathLight, CoincidentFacesDoNotDarken) {
  const Room once = cornell(diffuse(glm::vec3(0.8f)));
  Room twice = once;
  Mesh& mesh = twice.assets.meshes[0];
  std::vector<std::uint32_t>& materials = twice.assets.mesh_materials[0].of_triangle;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (materials[i] != 1) {  // not the lamp
      const auto [a, b, c] = mesh.triangles[i];
      mesh.triangles.push_back({a, c, b});
      materials.push_back(materials[i]);
    }
  }
  RenderOptions options = path_options(8, 8, 1024);
  const Estimate single = estimate(once, options);
  options.seed = 1;
  expect_same_means(single, estimate(twice, options), 1);
}

// A lamp in the plane of the ceiling, whichever of the two comes first, shines like one just below.
// Where it is hidden, the ceiling also reflects light there.
TEST(PathLight, LampsInThePlaneOfOtherFacesShine) {
  const auto mean = [](float height, bool lamp_first) {
    Room room;
    Model model;
    const std::uint32_t lamp = model.material(diffuse(glm::vec3(0), glm::vec3(12)));
    const auto add_lamp = [&] {
      model.quad({-0.3f, height, -0.3f}, {0.6f, 0, 0}, {0, 0, 0.6f}, lamp);
    };
    if (lamp_first) {
      add_lamp();
    }
    model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse(glm::vec3(0.6f))));
    if (!lamp_first) {
      add_lamp();
    }
    room.add(model);
    room.look({0, 1.2, 0.95}, {0, 0, -0.3}, 60);  // does not see the lamp
    return mean_of(draw(room, path_options(16, 16, 256)).image).x;
  };
  const double below = mean(1.9999f, false);
  for (const bool lamp_first : {false, true}) {
    EXPECT_NEAR(mean(2, lamp_first), below, 0.02 * below) << lamp_first;
  }
}

// Lamps at the same place, however they are cut into triangles, shine like one of them, for paths
// and for light samples.
TEST(PathLight, LampsAtTheSamePlaceShineOnce) {
  enum class Second { none, turned_triangles, other_diagonal, other_file, other_place };
  const auto mean = [](Second second, int light_samples, bool mis) {
    Room room;
    Model model;
    model.box({-1, 0, -1}, {1, 2, 1}, true, model.material(diffuse(glm::vec3(0.6f))));
    room.add(model);
    Model lamp;
    const std::uint32_t glowing = lamp.material(diffuse(glm::vec3(0), glm::vec3(2)));
    const glm::vec3 corner{-0.5f, 1.9f, -0.5f};
    const glm::vec3 u{1, 0, 0};
    const glm::vec3 v{0, 0, 1};
    lamp.quad(corner, u, v, glowing);
    if (second == Second::turned_triangles) {
      for (int i = 0; i < 2; ++i) {
        const auto [a, b, c] = lamp.mesh.triangles[i];
        lamp.mesh.triangles.push_back({b, c, a});
        lamp.materials.of_triangle.push_back(glowing);
      }
    }
    if (second == Second::other_diagonal) {
      lamp.quad(corner + u, v, -u, glowing);
    }
    room.add(lamp);
    if (second == Second::other_file) {
      room.add(lamp);
    }
    if (second == Second::other_place) {  // the group of a template
      room.scene.groups.push_back(room.scene.groups[0]);
      room.scene.groups[1].instances.push_back(room.instance(0, translate({0, 0, 0})));
      room.scene.root = 1;
    }
    room.look({0, 1.2, 0.95}, {0, 0, -0.3}, 60);
    RenderOptions options = path_options(8, 8, light_samples == 0 ? 512 : 128);
    options.max_depth = 2;
    options.light_samples = light_samples;
    options.mis = mis;
    return mean_of(draw(room, options).image).x;
  };
  const double one = mean(Second::none, 1, true);
  for (const Second second : {Second::turned_triangles, Second::other_diagonal, Second::other_file,
                              Second::other_place}) {
    EXPECT_NEAR(mean(second, 0, true), one, 0.06 * one) << static_cast<int>(second);
    EXPECT_NEAR(mean(second, 1, true), one, 0.06 * one) << static_cast<int>(second);
    EXPECT_NEAR(mean(second, 1, false), one, 0.06 * one) << static_cast<int>(second);
  }
}

// Two lamps at the same place that face opposite ways, or the back of another face at the lamp.
TEST(PathLight, LampsInFrontOfBacksAreSeen) {
  enum class Back { other_diagonal, other_file, mirrored, dark };
  for (const Back back : {Back::other_diagonal, Back::other_file, Back::mirrored, Back::dark}) {
    Room room;
    Model walls;
    walls.box(glm::vec3(-1), glm::vec3(1), true, walls.material(diffuse(glm::vec3(0.6f))));
    room.add(walls);
    Model lamp;
    Model other;
    const std::uint32_t glowing = lamp.material(diffuse(glm::vec3(0), glm::vec3(2)));
    const glm::vec3 corner{-0.5f, 0, -0.5f};
    lamp.quad(corner, {1, 0, 0}, {0, 0, 1}, glowing);  // shines downward
    if (back == Back::other_diagonal) {
      lamp.quad({-0.5f, 0, 0.5f}, {1, 0, 0}, {0, 0, -1}, glowing);
    }
    room.add(lamp);
    if (back == Back::mirrored) {
      room.add(lamp, scale({1, -1, 1}));
    }
    if (back == Back::other_file || back == Back::dark) {
      other.quad(corner, {0, 0, 1}, {1, 0, 0},
                 other.material(diffuse(glm::vec3(0.5f), glm::vec3(back == Back::dark ? 0 : 2))));
      room.add(other);
    }
    RenderOptions options = path_options(8, 8, 1);
    options.max_depth = 1;
    for (const float side : {-1.0f, 1.0f}) {
      SCOPED_TRACE(static_cast<int>(back));
      const bool shines = back != Back::dark || side < 0;
      options.samples = 16;
      options.light_samples = 1;
      room.look({0.1, 0.9 * side, 0.05}, {0, 0, 0}, 20);
      const Image seen = draw(room, options).image;
      for (const float value : seen.rgb) {
        ASSERT_TRUE(!shines || value == 2) << value;
      }
      room.look({0, 0.1 * side, 0.9}, {0, 1.0 * side, -0.3}, 40);
      options.samples = 512;
      const double sampled = mean_of(draw(room, options).image).x;
      options.light_samples = 0;
      EXPECT_NEAR(mean_of(draw(room, options).image).x, sampled, 0.06 * sampled);
      EXPECT_EQ(sampled > 0, shines);
    }
  }
}

// A lamp made of two faces at the same place shines to both sides, for paths and for light samples.
TEST(PathLight, FacesBackToBackShineToBothSides) {
  for (const bool below : {false, true}) {
    for (const int light_samples : {0, 1}) {
      Room room;
      Model model;
      const std::uint32_t white = model.material(diffuse(glm::vec3(0.5f)));
      model.quad({-5, -1, 5}, {10, 0, 0}, {0, 0, -10}, white);
      model.quad({-5, 1, -5}, {10, 0, 0}, {0, 0, 10}, white);
      model.quad({-1, 0, -1}, {2, 0, 0}, {0, 0, 2},
                 model.material(diffuse(glm::vec3(0), glm::vec3(1, 0, 0))));
      const auto first = static_cast<std::uint32_t>(model.mesh.triangles.size() - 2);
      const std::uint32_t blue = model.material(diffuse(glm::vec3(0), glm::vec3(0, 0, 2)));
      for (std::uint32_t t = first; t < first + 2; ++t) {
        const auto [a, b, c] = model.mesh.triangles[t];
        model.mesh.triangles.push_back({b, a, c});
        model.materials.of_triangle.push_back(blue);
      }
      room.add(model);
      // Looks past the lamp, at the wall that it faces.
      room.look({2, 0, 0}, {1.5, below ? -1 : 1, 0}, 1e-3);
      RenderOptions options = path_options(1, 1, 8192);
      options.max_depth = 1;
      options.light_samples = light_samples;
      const Image wall = draw(room, options).image;
      room.look({0, below ? -0.9 : 0.9, 0}, {0, 0, 0}, 10);
      options.samples = 1;
      const Image lamp = draw(room, options).image;
      const int shining = below ? 0 : 2;  // the red face is wound downward
      EXPECT_EQ(lamp.rgb[shining], below ? 1 : 2);
      EXPECT_EQ(lamp.rgb[2 - shining], 0);
      EXPECT_EQ(wall.rgb[2 - shining], 0);
      const double expected =
          (below ? 1 : 2) * 0.5 / pi *
          irradiance({{-2.5, -1, -1}, {-0.5, -1, -1}, {-0.5, -1, 1}, {-2.5, -1, 1}}, {0, 1, 0});
      EXPECT_NEAR(wall.rgb[shining], expected, 5e-3 * expected) << below << light_samples;
    }
  }
}

// Lights of the file shine by the equation of mode ray.
TEST(PathLight, SceneLightsAreThoseOfModeRay) {
  RenderMaterial m;
  m.ambient = glm::vec3(0);
  m.diffuse = {0.6f, 0.5f, 0.4f};
  m.specular = glm::vec3(0.3f);
  m.shininess = 12;
  Room room;
  room.scene.global.diffuse = 0.5f;
  room.scene.global.specular = 0.7f;
  const std::uint32_t plain = room.material(m);
  room.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5, 0)}, plain);
  room.add(Shape::sphere, Affine{glm::mat3(0.5f), glm::vec3(0.3f, 0.4f, 0)}, plain);
  room.light(LightType::point, {1, 2, 1}, {0.9f, 0.8f, 0.7f}).attenuation = {0.5f, 0.2f, 0.1f};
  room.light(LightType::directional, glm::normalize(glm::vec3(-0.3f, -1, 0.2f)),
             {0.2f, 0.3f, 0.4f});
  RenderLight& spot = room.light(LightType::spot, {-0.5f, 2, 0.3f}, {0.5f, 0.5f, 0.1f});
  spot.direction = {0, -1, 0};
  spot.inner_angle = 0.2f;
  spot.outer_angle = 0.5f;
  room.look({0, 2, 2}, {0, 0, 0}, 40);
  RenderOptions options = path_options(24, 18, 1);
  options.max_depth = 1;
  options.samples = 256;
  const Image path = draw(room, options).image;
  RenderOptions rays;
  rays.width = 24;
  rays.height = 18;
  rays.samples = rays.min_samples = 256;
  const Image ray = render(room.scene, room.assets, rays).image;
  const glm::dvec3 a = mean_of(path), b = mean_of(ray);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(a[c], b[c], 1e-3);
    EXPECT_GT(a[c], 0.05);
  }
  for (std::size_t i = 0; i < path.rgb.size(); ++i) {
    EXPECT_NEAR(path.rgb[i], ray.rgb[i], 0.02) << i;
  }
}

TEST(PathLight, AreaLightsAreThoseOfModeRay) {
  Room room;
  RenderMaterial m;
  m.ambient = glm::vec3(0);
  m.diffuse = glm::vec3(0.5f);
  room.add(Shape::cube, Affine{glm::mat3(10), glm::vec3(0, -5, 0)}, room.material(m));
  RenderLight& area = room.light(LightType::area, {0, 2, 0}, glm::vec3(1));
  area.direction = {0, -1, 0};
  area.half_u = {1, 0, 0};
  area.half_v = {0, 0, 1};
  area.attenuation = {0, 0, 1};
  room.look({0, 2, 2}, {0, 0, 0}, 40);
  RenderOptions options = path_options(4, 4, 1024);
  RenderOptions rays = options;
  rays.mode = Mode::ray;
  rays.min_samples = 1024;
  const glm::dvec3 a = mean_of(draw(room, options).image);
  const glm::dvec3 b = mean_of(render(room.scene, room.assets, rays).image);
  EXPECT_NEAR(a.x, b.x, 1e-3 * b.x);
}

// After the first bounce one of the lights is chosen.
TEST(PathLight, ManySceneLightsAreSampledWithoutBias) {
  Room room = closed_box(diffuse(glm::vec3(0.5f)));
  RenderOptions options = path_options(4, 4, 4096);
  room.light(LightType::point, {0, 0.5, 0}, glm::vec3(0.6f));
  const double one = mean_of(draw(room, options).image).x;
  room.scene.lights[0].color = glm::vec3(0.2f);
  room.light(LightType::point, {0, 0.5, 0}, glm::vec3(0.4f));
  EXPECT_NEAR(mean_of(draw(room, options).image).x, one, 5e-3 * one);
}

// The lobe alone where Ks is brighter; lamps are paths' ends here, so their light is not sampled.
TEST(PathCourse, DropsDiffuseWhereSpecularIsBrighter) {
  FaceMaterial m = diffuse(glm::vec3(0.4f));
  m.specular = glm::vec3(0.5f);
  m.shininess = 5;
  RenderOptions options = path_options(4, 4, 64);
  options.max_depth = 1;
  options.convention = Convention::course;
  const auto lit = [&](const FaceMaterial& floor) {
    Room room = closed_box(floor);
    room.light(LightType::point, {0, 0.5, 0}, glm::vec3(0.6f));
    return mean_of(draw(room, options).image).x;
  };
  FaceMaterial alone = m;
  alone.diffuse = glm::vec3(0);
  const double course = lit(m);
  EXPECT_EQ(course, lit(alone));
  m.specular = glm::vec3(0.3f);  // now diffuse reflection is brighter
  const double both = lit(m);
  options.convention = Convention::physics;
  EXPECT_EQ(lit(m), both);
  EXPECT_NEAR(lit(alone), course, 1e-12);
  m.specular = glm::vec3(0.5f);
  EXPECT_GT(lit(m), course + 0.02);
}

// A small lamp of two triangles at the height d: by 1/d instead of 1/d^2, and half of it.
TEST(PathCourse, LightFallsOffWithTheDistance) {
  for (const double d : {0.5, 2.0, 4.0}) {
    const float at = static_cast<float>(d);
    const Room room = under_lamp(0.8, {-0.01f, at, -0.01f}, {0.02f, 0, 0}, {0, 0, 0.02f}, 1000);
    RenderOptions options = path_options(1, 1, 256);
    options.max_depth = 1;
    const double physics = mean_of(draw(room, options).image).x;
    options.convention = Convention::course;
    ASSERT_GT(physics, 0);
    EXPECT_NEAR(mean_of(draw(room, options).image).x / physics, d / 2, 0.01 * d);
  }
}

// A mesh with materials of faces, whose own material is that of the glass between it and the light.
TEST(PathLight, GlassDimsTheLightWhateverUsesItsMaterial) {
  Room room;
  RenderMaterial clear;
  clear.diffuse = glm::vec3(0);
  clear.transparent = glm::vec3(0.5f);
  clear.ior = 1;
  const std::uint32_t shared = room.material(clear);
  Model floor;
  floor.quad({-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, floor.material(diffuse(glm::vec3(0.5f))));
  room.add(floor);
  room.scene.groups.back().primitives.back().material = shared;
  room.light(LightType::point, {0, 3, 0}, glm::vec3(1));
  room.look({0, 0.5, 2}, {0, 0, 0}, 1);
  RenderOptions options = path_options(1, 1, 4);
  options.direct_only = true;
  const double open = mean_of(draw(room, options).image).x;
  room.add(Shape::cube, translate({0, 2, 0}), shared);
  EXPECT_NEAR(mean_of(draw(room, options).image).x, open / 2, 1e-6);
  room.scene.groups.back().primitives.push_back(room.scene.groups.back().primitives.front());
  room.scene.groups.back().primitives.back().group_from_object = translate({0, 1, 0});
  EXPECT_EQ(mean_of(draw(room, options).image).x, 0);  // a mesh with materials blocks all light
}

TEST(PathLight, MapsMultiplyColors) {
  Room room;
  const std::uint32_t map = room.texture(1, 1, {51});
  Model model;
  FaceMaterial wall = diffuse(glm::vec3(0.5f), glm::vec3(0.25f));
  wall.diffuse_map = wall.emission_map = map;
  model.box(glm::vec3(-1), glm::vec3(1), true, model.material(wall));
  room.add(model);
  room.look({0, 0, 0}, {0, 0, -1}, 70);
  expect_everywhere(draw(room, path_options(4, 4, 1024)).image, 0.05 / 0.9, 1e-3);
}

}  // namespace
}  // namespace scenefile::path_test
