#include "client/publish/published_tile.h"

#include <random>
#include <zlib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/packing/zstd_frame.h"
#include "common/page_frames/page_frame_encoder.h"
#include "tests/common/pages/made_pages.h"

namespace burnish {
namespace {

/// A page whose vertices move by some steps of 1/256 cell.
struct MovedPage {
  explicit MovedPage(uint32_t seed, int steps_max, uint8_t gain = 0)
      : page(made_sheet({.id = 9}, seed)) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> step(-steps_max, steps_max);
    for (size_t vertex = 0; vertex < page.positions.size(); ++vertex) {
      const Vec3i way(step(random), step(random), step(random));
      move.displacements.push_back(way.cast<float>() / 256);
    }
    move.gain = gain;
  }

  /// Returns the body of a key frame that shows this page alone.
  std::string body() const {
    std::vector<int32_t> steps;
    for (int axis = 0; axis < 3; ++axis)
      for (const Vec3f& way : move.displacements)
        steps.push_back(static_cast<int32_t>(256 * way[axis]));
    const auto layout = std::make_shared<const PageLayout>(make_vertex_page_layout(page));
    const ShownPages shown = ShownPages().changed({1, {{page.id, layout}}, {}});
    const std::vector<WantedPage> wanted = {{steps, move.gain}};
    PageFrameEncoder encoder(PageFrameKind::kVertices);
    const auto frame = encoder.encode({shown, wanted, 1.0F}, kStillSteps).bytes;
    const auto bytes = decompress(std::span(frame).subspan(kPageFrameHeaderBytes),
                                  read_page_frame_header(frame)->body_bytes);
    return {bytes->begin(), bytes->end()};
  }

  Page page;
  PageMove move;
};

TEST(PublishedTile, IsTheBodyOfAKeyFrameBehindTheNumberOfItsValues) {
  for (const int steps_max : {1, 200, 100'000}) {
    const MovedPage moved(3, steps_max, 2);
    const size_t values = moved.page.positions.size();
    const std::string count{static_cast<char>(values & 255), static_cast<char>(values >> 8)};
    EXPECT_EQ(published_tile(moved.page, moved.move), count + moved.body());
  }
}

TEST(PublishedTile, IsPackedAsBrowsersUnpackIt) {
  const std::string tile = std::string(1000, 'a') + "b";
  const std::string packed = pack_tile(tile);
  EXPECT_LT(packed.size(), 100u);
  std::string again(tile.size(), '\0');
  uLongf size = again.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(again.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  EXPECT_EQ(again, tile);
  EXPECT_EQ(pack_tile(""), "");
}

TEST(PublishedTile, OfAPageThatHasNotMovedIsEmpty) {
  const MovedPage still(4, 0);
  EXPECT_EQ(published_tile(still.page, still.move), "");
}

TEST(PublishedTile, TellsTheGainOfAPageThatHasNotMoved) {
  const MovedPage still(4, 0, 3);
  EXPECT_EQ(published_tile(still.page, still.move).substr(2), std::string("\x02\x03"));
}

}  // namespace
}  // namespace burnish
