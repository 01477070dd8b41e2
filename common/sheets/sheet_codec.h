#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"
#include "common/sheets/sheet_format.h"
#include "common/sheets/webp_header.h"

namespace burnish {

/// The header of an encoded sheet, as it lies there (sheet_format.h).
struct SheetHeader {
  std::array<char, 4> magic = kSheetMagic;
  uint8_t version = kSheetFormatVersion;
  SheetCodec codec = SheetCodec::kLossyWebp;
  uint16_t charts = 0;
  uint32_t page = 0;
  uint8_t halving = 0;
  std::array<uint8_t, 3> zero = {};
  uint16_t width = 0;
  uint16_t height = 0;
  float density = 0;
  uint64_t checksum = 0;
};
static_assert(sizeof(SheetHeader) == kSheetHeaderBytes);

/// An encoded sheet, checked except for its texels. Refers to the bytes.
struct SheetRecord {
  SheetHeader header;
  SheetLayout layout;
  std::span<const uint8_t> webp;
};

/// Packs a sheet in the format of sheet_format.h. The same sheet gives the same bytes.
/// Needs: a layout of 1..kPageTrianglesMax charts; sides of kChartTexelsMin..kSheetSideMax; a
/// density of 0..kSheetDensityEnd, both outside. Fails: resource_exhausted.
Result<std::vector<uint8_t>> encode_sheet(const Sheet& sheet,
                                          SheetCodec codec = SheetCodec::kLossyWebp);

/// Checks header, checksum and places, and that the WebP's header says the same size, one frame and
/// the same codec. Decodes no texel: a browser does that itself. Safe for any bytes.
/// Fails: data_loss that names the damage; unimplemented (another version).
Result<SheetRecord> open_sheet(std::span<const uint8_t> bytes);

/// Decodes the texels too. Safe for any bytes. Fails: as open_sheet() does.
Result<Sheet> decode_sheet(std::span<const uint8_t> bytes);

/// Checks that a layout is one of this page's charts: a place for each chart, whose rectangle with
/// its gutter lies inside. `texels_per_step`: the sheet's density by the step of PageGrid.
/// Fails: data_loss that names the chart, its value and the limit.
Status check_sheet_layout(const SheetLayout& layout, const Page& page, const PageCharts& charts,
                          double texels_per_step);

}  // namespace burnish
