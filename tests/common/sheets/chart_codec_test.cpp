#include "common/sheets/chart_codec.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/packing/checksum.h"
#include "common/packing/zstd_frame.h"
#include "common/sheets/cut_charts.h"
#include "tests/common/pages/made_pages.h"
#include "tests/common/sheets/made_surfaces.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr size_t kChecksumAt = offsetof(ChartHeader, checksum);

std::vector<uint8_t> encoded_pair() {
  return encode_charts(0, cut_charts(two_triangles(), 1));
}

void seal(std::vector<uint8_t>& bytes) {
  const uint64_t checksum = sealed_checksum(bytes, kChecksumAt, sizeof(ChartHeader));
  std::memcpy(bytes.data() + kChecksumAt, &checksum, sizeof(checksum));
}

/// Returns the message for the charts of two triangles whose header `spoil` has changed and sealed.
template <typename Spoil>
std::string spoilt_header(Spoil spoil) {
  std::vector<uint8_t> bytes = encoded_pair();
  ChartHeader header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  spoil(header);
  std::memcpy(bytes.data(), &header, sizeof(header));
  seal(bytes);
  return decode_charts(bytes, two_triangles()).status().message();
}

/// Returns the message for a body whose byte `at` is another; two triangles have 33 bytes: turns,
/// 2 x 2 of names, 2 x 14 of charts.
std::string spoilt_body(size_t at, uint8_t value) {
  std::vector<uint8_t> bytes = encoded_pair();
  auto body = decompress(std::span(bytes).subspan(sizeof(ChartHeader)), 33).value();
  body.at(at) = value;
  bytes.resize(sizeof(ChartHeader));
  append_compressed(body, 1, bytes);
  seal(bytes);
  return decode_charts(bytes, two_triangles()).status().message();
}

TEST(ChartCodec, ChartsComeBack) {
  for (const Page& page :
       {two_triangles(), sphere_page(30, 1e6), ramp_page(1e5), made_soup(60, 200, 3)}) {
    const PageCharts charts = cut_charts(page, 1e-4);
    EXPECT_EQ(decode_charts(encode_charts(page.id, charts), page).value(), charts);
  }
}

TEST(ChartCodec, ASmoothPageTakesLessThanAQuarterOfAByteForATriangle) {
  const Page page = sphere_page(30, 1e6);
  const auto bytes = encode_charts(page.id, cut_charts(page, 1e-4));
  EXPECT_LT(static_cast<double>(bytes.size()), 0.25 * static_cast<double>(page.triangles.size()));
}

TEST(ChartCodec, EveryChangedBitIsNoticed) {
  const std::vector<uint8_t> good = encoded_pair();
  for (size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::vector<uint8_t> bad = good;
    bad[bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    EXPECT_FALSE(decode_charts(bad, two_triangles()).is_ok()) << bit;
  }
}

TEST(ChartCodec, EveryShorterAndLongerRecordIsRefused) {
  std::vector<uint8_t> bytes = encoded_pair();
  const auto code = [](std::span<const uint8_t> part) {
    return decode_charts(part, two_triangles()).status().code();
  };
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(code(std::span(bytes).first(size)), StatusCode::kDataLoss) << size;
  bytes.push_back(0);
  EXPECT_EQ(code(bytes), StatusCode::kDataLoss);
}

TEST(ChartCodec, AnotherVersionIsUnimplemented) {
  std::vector<uint8_t> bytes = encoded_pair();
  bytes[4] = 2;
  EXPECT_EQ(decode_charts(bytes, two_triangles()).status().code(), StatusCode::kUnimplemented);
}

TEST(ChartCodec, HeadersThatCannotBeAreNamed) {
  EXPECT_EQ(spoilt_header([](ChartHeader&) {}), "");
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.page = 7; }), HasSubstr("page is 7, not 0"));
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.zero[1] = 1; }), HasSubstr("reserved"));
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.charts = 3; }),
              HasSubstr("3 charts are outside 1..2"));
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.charts = 0; }), HasSubstr("0 charts"));
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.named = 1; }),
              HasSubstr("1 named charts are outside 2..2"));
  EXPECT_THAT(spoilt_header([](ChartHeader& h) { h.named = 65535; }), HasSubstr("65535 named"));
}

TEST(ChartCodec, BodiesThatCannotBeAreNamed) {
  EXPECT_EQ(spoilt_body(0, 3), "");
  EXPECT_THAT(spoilt_body(0, 1), HasSubstr("1 turns"));
  EXPECT_THAT(spoilt_body(0, 2), HasSubstr("1 turns"));
  EXPECT_THAT(spoilt_body(1, 2), HasSubstr("triangle 0 is in chart 2, the limit is 0"));
  EXPECT_THAT(spoilt_body(2, 0), HasSubstr("triangle 1 names chart 0"));
  EXPECT_THAT(spoilt_body(4, 1), HasSubstr("chart 257"));
  EXPECT_THAT(spoilt_body(32, 100), HasSubstr("after vertex"));
}

TEST(ChartCodec, ALargeRecordIsRefusedUnread) {
  EXPECT_THAT(decode_charts(std::vector<uint8_t>(131073), two_triangles()).status().message(),
              HasSubstr("131073 bytes are outside 0..131072"));
}

}  // namespace
}  // namespace burnish
