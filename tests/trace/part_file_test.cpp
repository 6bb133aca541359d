// Part files: reading returns what was written, and rejects everything else.

#include "scenefile/trace/part_file.h"

#include "scenefile/trace/part_set.h"
#include "scenefile/trace/picture_state.h"
#include "trace/build_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scenefile::trace_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

DividedPicture some_picture() {
  DividedPicture picture;
  picture.key = {1, 2, 3, 4, 5};
  picture.count = 7;
  picture.region = {10, 20, 110, 95};
  picture.rounding = Rounding::truncate;
  picture.max_depth = 4;
  picture.layers = {{LayerKind::depth, 0}, {LayerKind::light, 3}, {LayerKind::object_id, 0}};
  return picture;
}

PartHead some_head(std::uint32_t index = 3) {
  return {some_picture(), index, {{1, 2}, {}, {0, 8}}, 77};
}

std::string complaint(std::string_view bytes) {
  PartHead head;
  std::size_t before_rows = 0;
  return decode_part_head(bytes, head, before_rows);
}

TEST(PartFile, RoundTripsTheHead) {
  const std::string bytes = encode_part_head(some_head());
  PartHead head;
  std::size_t before_rows = 0;
  ASSERT_EQ(decode_part_head(bytes + "rows", head, before_rows), "");
  EXPECT_EQ(before_rows, bytes.size());
  EXPECT_TRUE(head == some_head());
}

TEST(PartFile, EveryTruncationIsDetected) {
  const std::string bytes = encode_part_head(some_head());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_NE(complaint(std::string_view(bytes).substr(0, length)), "") << length;
  }
  EXPECT_THAT(complaint(""), HasSubstr("empty"));
  EXPECT_THAT(complaint(bytes.substr(0, 30)), HasSubstr("truncated"));
}

TEST(PartFile, EveryDamagedBitIsDetected) {
  const std::string bytes = encode_part_head(some_head());
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      EXPECT_NE(complaint(damaged), "") << i;
    }
  }
}

TEST(PartFile, DescribesOtherFiles) {
  EXPECT_THAT(complaint("<scenefile/>"), HasSubstr("not a part"));
  EXPECT_THAT(complaint("scenefile part 9\n"), HasSubstr("another version"));
  EXPECT_TRUE(is_part_file("scenefile part 9\n"));
  EXPECT_FALSE(is_part_file("scenefile checkpoint 1\n"));
  EXPECT_EQ(foreign_part({1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}), "");
  EXPECT_THAT(foreign_part({9, 2, 3, 4, 5}, {1, 2, 3, 4, 5}), HasSubstr("another build"));
  EXPECT_THAT(foreign_part({1, 9, 3, 4, 5}, {1, 2, 3, 4, 5}), HasSubstr("another scene"));
  EXPECT_THAT(foreign_part({1, 2, 9, 4, 5}, {1, 2, 3, 4, 5}), HasSubstr("textures"));
  EXPECT_THAT(foreign_part({1, 2, 3, 9, 5}, {1, 2, 3, 4, 5}), HasSubstr("other options"));
  EXPECT_THAT(foreign_part({1, 2, 3, 4, 9}, {1, 2, 3, 4, 5}), HasSubstr("driver"));
}

// With a valid checksum.
TEST(PartFile, ImpossibleHeadersAreRejected) {
  const auto refused = [](auto change) {
    PartHead head = some_head();
    change(head);
    EXPECT_THAT(complaint(encode_part_head(head)), HasSubstr("its header is invalid"));
  };
  refused([](PartHead& h) { h.index = h.picture.count; });
  refused([](PartHead& h) { h.picture.count = 0; });
  refused([](PartHead& h) { h.picture.count = max_parts + 1; });
  refused([](PartHead& h) { h.picture.region = {}; });
  refused([](PartHead& h) { h.picture.region.x0 = -1; });
  refused([](PartHead& h) { h.picture.region.y1 = 1 << 30; });
  refused([](PartHead& h) { h.picture.rounding = static_cast<Rounding>(7); });
  refused([](PartHead& h) { h.picture.layers[0].kind = static_cast<LayerKind>(99); });
  refused([](PartHead& h) { h.ranges.pop_back(); });
}

RC_GTEST_PROP(PartFile, PartsCoverTheRegionOnce, ()) {
  const int x0 = *rc::gen::inRange(0, 40);
  const int y0 = *rc::gen::inRange(0, 40);
  const PixelRegion whole{x0, y0, x0 + *rc::gen::inRange(1, 200), y0 + *rc::gen::inRange(1, 150)};
  const auto count = *rc::gen::inRange<std::uint32_t>(1, 300);
  std::vector<int> covered(std::size_t(whole.width()) * whole.height());
  for (std::uint32_t index = 0; index < count; ++index) {
    const PixelRegion part = part_of(whole, index, count);
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) {
        RC_ASSERT(x >= whole.x0 && x < whole.x1 && y >= whole.y0 && y < whole.y1);
        ++covered[std::size_t(y - whole.y0) * whole.width() + (x - whole.x0)];
      }
    }
  }
  RC_ASSERT(std::all_of(covered.begin(), covered.end(), [](int n) { return n == 1; }));
}

TEST(PartFile, RowsOfPartsMakeThePicture) {
  SceneBuilder b;
  b.add(Shape::sphere, translate({0, 0, -3}), b.material({}));
  b.light(LightType::point, {0, 2, 0}, glm::vec3(1));
  RenderOptions options = default_options(Profile::fine);
  options.width = 90;
  options.height = 61;
  options.crop = PixelRegion{3, 5, 88, 60};
  options.layers = {{LayerKind::depth, 0}, {LayerKind::normal, 0}, {LayerKind::object_id, 0}};
  const RenderResult whole = render(b.scene, b.assets, options);

  DividedPicture picture = some_picture();
  picture.region = *options.crop;
  picture.layers = options.layers;
  std::vector<ImageLayer> merged{{"", {"R", "G", "B"}, false, {}}};
  for (const Layer& layer : options.layers) {
    merged.push_back(layer_without_values(layer));
  }
  for (ImageLayer& layer : merged) {
    layer.values.resize(layer.channels.size() * whole.image.rgb.size() / 3, -1);
  }
  ValueRange depths;
  for (std::uint32_t index = 0; index < picture.count; ++index) {
    RenderOptions own = options;
    own.crop = part_of(picture.region, index, picture.count);
    const RenderResult part = render(b.scene, b.assets, own);
    const PartHead head = make_part_head(picture, index, part.image, part.layers);
    depths = joined(depths, head.ranges[0]);
    std::string rows;
    for (int y = 0; y < part.image.height; ++y) {
      rows += part_row(part.image, part.layers, y);
    }
    EXPECT_EQ(part_file_bytes(head, 100), 100 + rows.size());
    place_part_rows(head, rows, own.crop->y0, picture.region.y0, merged);
  }
  EXPECT_TRUE(merged[0].values == whole.image.rgb);
  for (std::size_t i = 0; i < whole.layers.size(); ++i) {
    EXPECT_TRUE(merged[i + 1].values == whole.layers[i].values) << whole.layers[i].name;
  }
  EXPECT_EQ(depths, range_of(whole.layers[0].values));
}

PartCandidate candidate(std::uint32_t index, std::uint64_t scene = 2, std::string damage = {}) {
  PartCandidate c{some_head(index), true, std::move(damage)};
  c.head.picture.count = 4;
  c.head.picture.key.scene = scene;
  return c;
}

TEST(PartSet, FindsDefects) {
  const std::vector<PartCandidate> files{
      candidate(1), candidate(3), candidate(1), candidate(0, 9), candidate(2, 2, "truncated"), {}};
  std::vector<PartCandidate> with_unreadable = files;
  with_unreadable.back().damage = "the file is empty";
  const PartSet set = sort_parts(with_unreadable);
  EXPECT_FALSE(set.complete());
  EXPECT_EQ(set.picture.key.scene, 2u);
  EXPECT_THAT(set.missing, ElementsAre(0, 2));
  EXPECT_THAT(set.doubled, ElementsAre(2));
  EXPECT_THAT(set.foreign, ElementsAre(3));
  EXPECT_THAT(set.damaged, ElementsAre(4, 5));
  EXPECT_THAT(set.files, ElementsAre(no_file, 0, no_file, 1));
}

TEST(PartSet, IsCompleteWithAllParts) {
  const std::vector<PartCandidate> files{candidate(3), candidate(0), candidate(2), candidate(1)};
  const PartSet set = sort_parts(files);
  EXPECT_TRUE(set.complete());
  EXPECT_THAT(set.files, ElementsAre(1, 3, 2, 0));
  EXPECT_FALSE(sort_parts(std::span<const PartCandidate>()).complete());
  const std::vector<PartCandidate> unknown(2);
  EXPECT_THAT(sort_parts(unknown).damaged, ElementsAre(0, 1));
}

TEST(PartSet, NumbersAreListedAsRanges) {
  const std::vector<std::uint32_t> none;
  EXPECT_THAT(part_numbers(none), IsEmpty());
  const std::vector<std::uint32_t> some{2, 6, 7, 8, 11, 12};
  EXPECT_EQ(part_numbers(some), "3, 7-9, 12, 13");
}

}  // namespace
}  // namespace scenefile::trace_test
