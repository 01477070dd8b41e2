#include "client/surface/page_decoder.h"

#include <gtest/gtest.h>

#include "common/pages/page_codec.h"
#include "tests/client/surface/wakeup_count.h"
#include "tests/common/pages/made_pages.h"
#include "tests/common/pages/made_scan.h"

namespace burnish {
namespace {

PageHead head_of_made_scan() {
  PageHead head;
  head.grid = made_scan().grid;
  head.has_colours = made_scan().has_colours;
  head.level_pages = {2, 2, 1};
  return head;
}

TEST(PageDecoder, APageComesBackWithWhatIsDrawnOfIt) {
  WakeupCount news;
  PageDecoder decoder(head_of_made_scan(), news.caller());
  const Page page = made_scan_pages().at(3);
  decoder.decode(3, encode_page(page));
  EXPECT_TRUE(decoder.has(3));
  news.wait_for(1);
  const std::vector<DecodedPage> done = decoder.take();
  ASSERT_EQ(done.size(), 1u);
  ASSERT_TRUE(done[0].page.is_ok()) << done[0].page.status().message();
  EXPECT_EQ(done[0].id, 3u);
  EXPECT_EQ(meaning_of(*done[0].page), meaning_of(page));
  EXPECT_EQ(done[0].mesh.positions.size(), page.positions.size());
  EXPECT_FALSE(decoder.has(3));
}

TEST(PageDecoder, ADamagedPageAndAnotherPageFail) {
  WakeupCount news;
  PageDecoder decoder(head_of_made_scan(), news.caller());
  std::vector<uint8_t> damaged = encode_page(made_scan_pages().at(1));
  damaged.back() ^= 1;
  decoder.decode(1, damaged);
  decoder.decode(2, encode_page(made_scan_pages().at(3)));
  news.wait_for(2);
  for (const DecodedPage& done : decoder.take()) {
    EXPECT_EQ(done.page.status().code(), StatusCode::kDataLoss) << done.id;
    EXPECT_TRUE(done.mesh.positions.empty());
  }
}

TEST(PageDecoder, ItTakesOnlySoManyPagesAtOnce) {
  PageDecoder decoder(head_of_made_scan(), [] {});
  PageId taken = 0;
  while (decoder.has_room()) decoder.decode(taken++, {});
  EXPECT_GE(taken, 4u);
  EXPECT_LE(taken, 64u);
}

}  // namespace
}  // namespace burnish
