#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet_format.h"

namespace burnish {

/// The header of encoded charts, as it lies there (sheet_format.h).
struct ChartHeader {
  std::array<char, 4> magic = kChartMagic;
  uint8_t version = kSheetFormatVersion;
  std::array<uint8_t, 3> zero = {};
  uint32_t page = 0;
  uint16_t charts = 0;
  uint16_t named = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(ChartHeader) == kChartHeaderBytes);

/// Packs the charts of a page. Needs: check_charts() is ok for the page as decode_page() returns
/// it, whose triangles are in another order than an encoder's.
std::vector<uint8_t> encode_charts(PageId page, const PageCharts& charts);

/// Safe for any bytes. Fails: data_loss that names the damage, also if the record is not that of
/// this page or its charts fail check_charts(); unimplemented (another version).
Result<PageCharts> decode_charts(std::span<const uint8_t> bytes, const Page& page);

}  // namespace burnish
