// The other draw modes.

#include "scenefile/view/vertices.h"
#include "view/build_scene.h"

namespace scenefile {

namespace {

using namespace view_test;

class Mode : public Drawn {
 protected:
  Mode() { builder.add(Shape::cube, place({0, 0, -3}), builder.glowing({1, 1, 1})); }

  Image drawn(DrawMode mode) {
    DrawOptions options;
    options.mode = mode;
    options.samples = 1;
    Drawing drawing = uploaded(builder);
    return draw_square(drawing, builder.scene.camera, options, 33);
  }

  SceneBuilder builder;
};

TEST_F(Mode, NormalsAreColors) {
  const glm::vec3 middle = at(drawn(DrawMode::normals), 16, 16);
  EXPECT_NEAR(middle.r, 0.5, 0.003);
  EXPECT_NEAR(middle.g, 0.5, 0.003);
  EXPECT_NEAR(middle.b, 1, 0.003);
}

TEST_F(Mode, UvAreRedAndGreen) {
  const Image image = drawn(DrawMode::uv);
  EXPECT_NEAR(at(image, 16, 16).r, 0.5, 0.05);
  EXPECT_GT(at(image, 20, 16).r, at(image, 12, 16).r) << "u to the right";
  EXPECT_GT(at(image, 16, 12).g, at(image, 16, 20).g) << "v upward";
}

TEST_F(Mode, NearIsBrighterThanFar) {
  builder.add(Shape::cube, place({0, 0, -9}, 4), 0);
  const Image image = drawn(DrawMode::depth);
  EXPECT_GT(at(image, 16, 16).r, at(image, 4, 16).r);
}

TEST_F(Mode, ObjectsHaveDifferentColors) {
  builder.add(Shape::cube, place({0, 0, -9}, 4), 0);
  const Image image = drawn(DrawMode::object_id);
  EXPECT_NE(at(image, 16, 16), at(image, 8, 16));
  EXPECT_EQ(at(image, 15, 15), at(image, 17, 17));
}

TEST_F(Mode, BoxesBehindEachOtherAddUp) {
  const float one = at(drawn(DrawMode::bounding_boxes), 16, 16).r;
  builder.add(Shape::sphere, place({0, 0, -6}), 0);
  EXPECT_NEAR(at(drawn(DrawMode::bounding_boxes), 16, 16).r, 2 * one, 0.01);
}

TEST_F(Mode, WiresLeaveFacesOpen) {
  const Image image = drawn(DrawMode::wireframe);
  std::size_t lit = 0;
  for (int y = 0; y < 33; ++y) {
    for (int x = 0; x < 33; ++x) {
      lit += at(image, x, y).r > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(lit, 40u);
  EXPECT_LT(lit, 200u);
}

TEST(Vertices, EachEdgeOccursOnce) {
  EXPECT_EQ(edges({0, 1, 2, 2, 1, 3}).size(), 2u * 5);
  EXPECT_EQ(bent_edges(shape_vertices(Shape::cube, 8)).size(), 2u * 12) << "no diagonals";
  EXPECT_EQ(bent_edges(shape_vertices(Shape::cylinder, 8)).size(), 2u * 3 * 8);
}

TEST(Vertices, RoundShapesHaveTheAreaOfTheirCircles) {
  const DrawVertices cylinder = shape_vertices(Shape::cylinder, 8);
  double area = 0;
  for (std::size_t i = 0; i < cylinder.triangles.size(); i += 3) {
    const glm::dvec3 a(cylinder.vertices[cylinder.triangles[i]].position);
    const glm::dvec3 b(cylinder.vertices[cylinder.triangles[i + 1]].position);
    const glm::dvec3 c(cylinder.vertices[cylinder.triangles[i + 2]].position);
    const bool cap = a.y == b.y && b.y == c.y && a.y > 0;
    area += cap ? 0.5 * glm::length(glm::cross(b - a, c - a)) : 0;
  }
  EXPECT_NEAR(area, 0.25 * 3.14159265, 1e-5);
}

}  // namespace

}  // namespace scenefile
