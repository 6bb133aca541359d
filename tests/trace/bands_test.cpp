#include "scenefile/trace/bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace scenefile {
namespace {

TEST(Bands, SharesCoverThePictureInWholeBlocks) {
  for (const int height : {1, 16, 17, 480, 1079, 4320}) {
    for (const std::uint32_t count : {1u, 2u, 3u, 7u, 64u, 1000u, max_shares}) {
      int y = 0;
      int least = height;
      int most = 0;
      for (std::uint32_t i = 0; i < std::min(count, 2000u); ++i) {
        const RowRange share = share_of({0, height}, i, count);
        EXPECT_EQ(share.first, y);
        EXPECT_TRUE(share.first % 16 == 0 || share.rows() == 0) << share.first;
        EXPECT_TRUE(share.end % 16 == 0 || share.end == height);
        y = share.end;
        least = std::min(least, share.rows());
        most = std::max(most, share.rows());
      }
      if (count <= 2000) {
        EXPECT_EQ(y, height);
        EXPECT_LT(most - least, 32);
      }
      EXPECT_EQ(share_of({0, height}, count - 1, count).end, height);
    }
  }
  EXPECT_EQ(share_of({32, 100}, 0, 2), (RowRange{32, 64}));
  EXPECT_EQ(share_of({32, 100}, 1, 2), (RowRange{64, 100}));
}

TEST(Bands, RowsWithoutBands) {
  const std::vector<RowRange> bands{{64, 96}, {16, 48}, {32, 48}, {64, 80}};
  const std::vector<RowRange> all{{0, 16}, {48, 64}, {96, 120}};
  EXPECT_EQ(rows_without(bands, {0, 120}), all);
  EXPECT_EQ(rows_without(bands, {16, 48}), std::vector<RowRange>());
  EXPECT_EQ(rows_without(bands, {40, 60}), (std::vector<RowRange>{{48, 60}}));
  EXPECT_EQ(rows_without({}, {3, 4}), (std::vector<RowRange>{{3, 4}}));
  EXPECT_EQ(rows_without({}, {3, 3}), std::vector<RowRange>());
}

TEST(Bands, HeightsFollowMarginsAndThreads) {
  EXPECT_EQ(rows_of_band(7680, 4320, 1, 2), 64);
  EXPECT_EQ(rows_of_band(7680, 4320, 11, 2), 704);
  EXPECT_EQ(rows_of_band(640, 480, 0, 1), 16);
  EXPECT_EQ(rows_of_band(640, 480, 0, 2), 32);
  EXPECT_EQ(rows_of_band(640, 480, 1, 16), 208);
  EXPECT_EQ(rows_of_band(1, 1 << 20, 0, 1), 1 << 14);
  for (const int threads : {-1, 0, 1, 64, 1024}) {
    EXPECT_EQ(rows_of_band(1, 1, 0, threads) % 16, 0);
    EXPECT_GT(rows_of_band(1, 1, 0, threads), 0);
  }
}

TEST(Bands, NamesAreRead) {
  EXPECT_EQ(band_name({64, 128}), "00064-00128.exr");
  EXPECT_EQ(band_of_name("00064-00128.exr"), (RowRange{64, 128}));
  EXPECT_EQ(band_of_name(band_name({1048560, 1048576})), (RowRange{1048560, 1048576}));
  for (const char* const other :
       {"", "-", "64-128.exr", "00064-00128.exr.tmp", "00064-00064.exr", "00128-00064.exr",
        "-0064-00128.exr", "00064-0128.exr", "000064-00128.exr", "00064_00128.exr",
        "00064-00128.png", "99999999999-00128.exr"}) {
    EXPECT_EQ(band_of_name(other), std::nullopt) << other;
  }
}

}  // namespace
}  // namespace scenefile
