#include "common/pages/directory_codec.h"

#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/pages/made_scan.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Returns the pages of block `index` of the made directory.
DirectoryBlock made_block(uint32_t index) {
  const PageDirectory directory = made_directory();
  const PageRange pages = directory.head.pages_of(index);
  DirectoryBlock block{.begin = pages.begin};
  for (PageId page = pages.begin; page < pages.end; ++page) {
    block.entries.push_back(directory.entries[page]);
    block.coarser.add(directory.coarser[page]);
  }
  return block;
}

/// Returns the message for the head after `spoil` has changed it.
template <typename Spoil>
std::string spoilt_head(Spoil spoil) {
  PageHead head = made_directory().head;
  spoil(head);
  return decode_head(encode_head(head)).status().message();
}

/// Returns the message for block 1 after `spoil` has changed it.
template <typename Spoil>
std::string spoilt_block(Spoil spoil) {
  DirectoryBlock block = made_block(1);
  spoil(block);
  return decode_block(encode_block(block), made_directory().head, 1).status().message();
}

TEST(HeadCodec, EveryFieldComesBack) {
  PageHead head = made_directory().head;
  head.has_colours = true;
  const PageHead decoded = decode_head(encode_head(head)).value();
  EXPECT_EQ(decoded.grid.origin, head.grid.origin);
  EXPECT_EQ(decoded.grid.side, head.grid.side);
  EXPECT_EQ(decoded.grid.bits, head.grid.bits);
  EXPECT_TRUE(decoded.has_colours);
  EXPECT_EQ(decoded.scan_vertices, 700u);
  EXPECT_EQ(decoded.scan_triangles, 900u);
  EXPECT_EQ(decoded.level_pages, head.level_pages);
  EXPECT_EQ(decoded.blocks, head.blocks);
  EXPECT_EQ(decoded.page_bytes, head.page_bytes);
  EXPECT_EQ(decoded.block_bytes, head.block_bytes);
}

TEST(HeadCodec, EveryChangedBitAndEveryOtherLengthIsRefused) {
  std::vector<uint8_t> good = encode_head(made_directory().head);
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::vector<uint8_t> bad = good;
    bad[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    EXPECT_FALSE(decode_head(bad).is_ok()) << bit;
  }
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(decode_head(std::span(good).first(size)).is_ok()) << size;
  good.push_back(0);
  EXPECT_FALSE(decode_head(good).is_ok());
}

TEST(HeadCodec, OtherPagesHaveAnotherFingerprint) {
  PageHead head = made_directory().head;
  const uint64_t fingerprint = pages_fingerprint(encode_head(head));
  EXPECT_EQ(pages_fingerprint(encode_head(head)), fingerprint);
  head.blocks.front().bytes += 8;
  EXPECT_NE(pages_fingerprint(encode_head(head)), fingerprint);
}

TEST(HeadCodec, AnotherVersionIsUnimplemented) {
  std::vector<uint8_t> bytes = encode_head(made_directory().head);
  bytes[4] = 2;
  EXPECT_EQ(decode_head(bytes).status().code(), StatusCode::kUnimplemented);
}

TEST(HeadCodec, ScalarsOutsideTheirLimitsAreNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spoilt_head([](PageHead&) {}), "");
  for (const int bits : {0, 25})
    EXPECT_THAT(spoilt_head([&](PageHead& h) { h.grid.bits = bits; }), HasSubstr("1..24"));
  for (const double side : {0.0, -1.0, kNan, 1e300})
    EXPECT_THAT(spoilt_head([&](PageHead& h) { h.grid.side = side; }), HasSubstr("side"));
  for (const double origin : {kNan, 1e300})
    EXPECT_THAT(spoilt_head([&](PageHead& h) { h.grid.origin.y() = origin; }), HasSubstr("origin"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.scan_triangles = 0; }), HasSubstr("triangles 0"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.scan_vertices = uint64_t{1} << 40; }),
              HasSubstr("vertices"));
}

TEST(HeadCodec, LevelsThatCannotBeAreNamed) {
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.level_pages = {}; }), HasSubstr("levels 0"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.level_pages = {300, 0, 1}; }), HasSubstr("level 1"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.level_pages = {300, 2}; }), HasSubstr("1..1"));
  EXPECT_THAT(spoilt_head([](PageHead& h) {
                h.level_pages = {1u << 24, 1};
              }),
              HasSubstr("pages 16777217"));
  EXPECT_THAT(spoilt_head([](PageHead& h) {
                h.level_pages = {600, 2, 1};
              }),
              HasSubstr("5 blocks need"));
}

TEST(HeadCodec, BlocksThatLeaveGapsOrLieOutsideAreNamed) {
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.blocks[0].page_begin = 1; }), HasSubstr("block 0"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.blocks[2].page_begin = 25600; }),
              HasSubstr("block 1"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { h.page_bytes = uint64_t{1} << 40; }),
              HasSubstr("block 3"));
  EXPECT_THAT(spoilt_head([](PageHead& h) { ++h.block_bytes; }), HasSubstr("320"));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float value : {-1.0f, kInfinity, kInfinity - kInfinity}) {
    EXPECT_THAT(spoilt_head([&](PageHead& h) { h.blocks[1].bounds.radius = value; }),
                HasSubstr("block 1: radius"));
    EXPECT_THAT(spoilt_head([&](PageHead& h) { h.blocks[1].bounds.error = value; }),
                HasSubstr("block 1: error"));
  }
}

TEST(BlockCodec, EveryFieldComesBack) {
  const PageHead head = made_directory().head;
  for (uint32_t index = 0; index < head.block_count(); ++index) {
    const DirectoryBlock block = made_block(index);
    const DirectoryBlock decoded = decode_block(encode_block(block), head, index).value();
    EXPECT_EQ(decoded.begin, block.begin);
    EXPECT_EQ(decoded.entries, block.entries);
    EXPECT_EQ(decoded.coarser.start, block.coarser.start);
    EXPECT_EQ(decoded.coarser.item, block.coarser.item);
  }
}

TEST(BlockCodec, EveryChangedBitAndEveryOtherLengthIsRefused) {
  const PageHead head = made_directory().head;
  std::vector<uint8_t> good = encode_block(made_block(2));
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::vector<uint8_t> bad = good;
    bad[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    EXPECT_FALSE(decode_block(bad, head, 2).is_ok()) << bit;
  }
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(decode_block(std::span(good).first(size), head, 2).is_ok()) << size;
  good.push_back(0);
  EXPECT_FALSE(decode_block(good, head, 2).is_ok());
}

TEST(BlockCodec, ABlockInAnothersPlaceIsRefused) {
  const PageHead head = made_directory().head;
  EXPECT_THAT(decode_block(encode_block(made_block(1)), head, 0).status().message(),
              HasSubstr("first page 256"));
}

TEST(BlockCodec, AnotherVersionIsUnimplemented) {
  std::vector<uint8_t> bytes = encode_block(made_block(1));
  bytes[4] = 2;
  EXPECT_EQ(decode_block(bytes, made_directory().head, 1).status().code(),
            StatusCode::kUnimplemented);
}

TEST(BlockCodec, EntriesOutsideTheirLimitsAreNamed) {
  EXPECT_EQ(spoilt_block([](DirectoryBlock&) {}), "");
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.entries[3].vertices = 2049; }),
              HasSubstr("page 259: vertices 2049"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.entries[3].triangles = 0; }),
              HasSubstr("1..4096"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.entries[3].bytes = 48; }),
              HasSubstr("bytes 48"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { ++b.entries[3].bytes; }),
              HasSubstr("4401 is outside 4400..4400"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.entries[3].bounds.error = 1; }),
              HasSubstr("page 259: error"));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.entries[3].bounds.centre.x() = kNan; }),
              HasSubstr("centre"));
}

TEST(BlockCodec, CoarserPagesThatCannotBeAreNamed) {
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.coarser.item[0] = 299; }),
              HasSubstr("page 256: coarser page 299 is outside 300..301"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.coarser.item[1] = 302; }),
              HasSubstr("coarser page 302"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.coarser.item[1] = 300; }),
              HasSubstr("301..301"));
  EXPECT_THAT(spoilt_block([](DirectoryBlock& b) { b.coarser.start[1] = 0; }),
              HasSubstr("coarser pages 0"));
}

TEST(BlockCodec, TheRootHasNoCoarserPage) {
  DirectoryBlock root = made_block(3);
  root.coarser = {};
  root.coarser.add(std::vector<PageId>{302});
  EXPECT_THAT(decode_block(encode_block(root), made_directory().head, 3).status().message(),
              HasSubstr("of the root"));
}

}  // namespace
}  // namespace burnish
