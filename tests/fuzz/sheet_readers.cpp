#include "common/base/check.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_format.h"
#include "tests/fuzz/readers.h"
#include "tests/fuzz/sealed_part.h"

namespace burnish {

namespace {

/// A bent square of eight triangles.
Page small_page() {
  Page page{.id = 5, .patches = {{kNoPage, 8}}};
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) page.positions.emplace_back(1000 * x, 1000 * y, 900 * x * x);
  for (const int corner : {0, 1, 3, 4}) {
    const auto at = [corner](int step) { return static_cast<uint16_t>(corner + step); };
    page.triangles.push_back({at(0), at(1), at(3)});
    page.triangles.push_back({at(3), at(1), at(4)});
  }
  return page;
}

}  // namespace

bool read_fuzzed_charts(std::span<const uint8_t> bytes) {
  (void)decode_charts(bytes, small_page());
  const auto charts = decode_charts(compressed(bytes, kChartHeaderBytes), small_page());
  if (!charts.is_ok()) return false;
  const auto again = decode_charts(encode_charts(small_page().id, *charts), small_page());
  BURNISH_CHECK(again.is_ok() && *again == *charts, "charts do not read back");
  return true;
}

}  // namespace burnish
