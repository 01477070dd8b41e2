#include "common/sheets/sheet_codec.h"

#include <algorithm>
#include <bit>
#include <string>

#include "common/base/limits.h"
#include "common/packing/byte_planes.h"
#include "common/packing/zstd_frame.h"
#include "common/sheets/sheet_checks.h"
#include "common/sheets/sheet_limits.h"
#include "common/sheets/webp_texels.h"

namespace burnish {

namespace {

static_assert(std::endian::native == std::endian::little, "sheets are written as they lie");

constexpr int kPlaceZstdLevel = 5;
constexpr size_t kBytesPerPlace = 4;

std::string sheet_name(const SheetHeader& header) {
  return "sheet " + std::to_string(header.halving) + " of page " + std::to_string(header.page);
}

Status check_sheet_header(const SheetHeader& header) {
  RETURN_IF_ERROR(check_sheet_value("codec", static_cast<uint64_t>(header.codec), 1, 2));
  RETURN_IF_ERROR(check_sheet_value("charts", header.charts, 1, kPageTrianglesMax));
  RETURN_IF_ERROR(check_sheet_value("halvings", header.halving, 0, kSheetsPerPageMax - 1));
  if (header.zero != std::array<uint8_t, 3>{}) return data_loss("reserved bits are set");
  RETURN_IF_ERROR(
      check_sheet_value("texels of width", header.width, kChartTexelsMin, kSheetSideMax));
  RETURN_IF_ERROR(
      check_sheet_value("texels of height", header.height, kChartTexelsMin, kSheetSideMax));
  return check_sheet_density(header.density);
}

/// Checks what holds for a chart of any size.
Status check_places(const SheetLayout& layout) {
  for (size_t c = 0; c < layout.places.size(); ++c) {
    const auto& [x, y] = layout.places[c];
    if (x + kChartTexelsMin > layout.width || y + kChartTexelsMin > layout.height)
      return data_loss("chart " + std::to_string(c) + " lies at " + std::to_string(x) + ", " +
                       std::to_string(y) + ", the limit is " +
                       std::to_string(layout.width - kChartTexelsMin) + ", " +
                       std::to_string(layout.height - kChartTexelsMin));
  }
  return Status::ok();
}

std::vector<TexelPlace> unpacked_places(std::span<const uint8_t> table) {
  const size_t count = table.size() / kBytesPerPlace;
  std::vector<uint16_t> xs(count);
  std::vector<uint16_t> ys(count);
  read_planes<uint16_t>(table.first(2 * count), 2, xs);
  read_planes<uint16_t>(table.subspan(2 * count), 2, ys);
  std::vector<TexelPlace> places;
  for (size_t c = 0; c < count; ++c) places.push_back({xs[c], ys[c]});
  return places;
}

void append_places(std::span<const TexelPlace> places, std::vector<uint8_t>& bytes) {
  std::vector<uint16_t> xs;
  std::vector<uint16_t> ys;
  for (const TexelPlace& place : places) {
    xs.push_back(place.x);
    ys.push_back(place.y);
  }
  std::vector<uint8_t> table;
  append_planes<uint16_t>(xs, 2, table);
  append_planes<uint16_t>(ys, 2, table);
  append_compressed(table, kPlaceZstdLevel, bytes);
}

Result<SheetRecord> open_body(const SheetHeader& header, std::span<const uint8_t> body) {
  RETURN_IF_ERROR(check_sheet_header(header));
  ASSIGN_OR_RETURN(const size_t table_bytes, compressed_bytes(body));
  ASSIGN_OR_RETURN(const auto table,
                   decompress(body.first(table_bytes), kBytesPerPlace * header.charts));
  SheetRecord record{.header = header,
                     .layout = {header.width, header.height, unpacked_places(table)},
                     .webp = body.subspan(table_bytes)};
  RETURN_IF_ERROR(check_places(record.layout));
  RETURN_IF_ERROR(check_webp(record.webp, header.width, header.height, header.codec));
  return record;
}

}  // namespace

Result<std::vector<uint8_t>> encode_sheet(const Sheet& sheet, SheetCodec codec) {
  const SheetHeader header{.codec = codec,
                           .charts = static_cast<uint16_t>(sheet.layout.places.size()),
                           .page = sheet.page,
                           .halving = sheet.halving,
                           .width = sheet.layout.width,
                           .height = sheet.layout.height,
                           .density = sheet.density};
  auto webp = encode_webp(sheet.texels, header.width, header.height, codec);
  if (!webp.is_ok()) return webp.status().with_context(sheet_name(header));
  std::vector<uint8_t> bytes(kSheetHeaderBytes);
  append_places(sheet.layout.places, bytes);
  bytes.insert(bytes.end(), webp->begin(), webp->end());
  seal_record(header, bytes);
  return bytes;
}

Result<SheetRecord> open_sheet(std::span<const uint8_t> bytes) {
  auto header = read_sealed<SheetHeader>(bytes, kSheetBytesMax);
  if (!header.is_ok()) return header.status().with_context("sheet");
  auto record = open_body(*header, bytes.subspan(sizeof(SheetHeader)));
  if (!record.is_ok()) return record.status().with_context(sheet_name(*header));
  return record;
}

Result<Sheet> decode_sheet(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const SheetRecord record, open_sheet(bytes));
  const SheetHeader& header = record.header;
  auto texels = decode_webp(record.webp, header.width, header.height, header.codec);
  if (!texels.is_ok()) return texels.status().with_context(sheet_name(header));
  return Sheet{header.page, header.halving, header.density, record.layout,
               std::move(texels).value()};
}

Status check_sheet_layout(const SheetLayout& layout, const Page& page, const PageCharts& charts,
                          double texels_per_step) {
  const std::vector<TexelSize> sizes = chart_sizes(page, charts, texels_per_step);
  const std::string name = "a sheet of page " + std::to_string(page.id);
  if (layout.places.size() != sizes.size())
    return data_loss(name + " has " + std::to_string(layout.places.size()) + " charts, the page " +
                     std::to_string(sizes.size()));
  for (size_t c = 0; c < sizes.size(); ++c) {
    const uint32_t right = layout.places[c].x + sizes[c].width;
    const uint32_t bottom = layout.places[c].y + sizes[c].height;
    if (right > layout.width || bottom > layout.height)
      return data_loss(name + ": chart " + std::to_string(c) + " ends at " + std::to_string(right) +
                       ", " + std::to_string(bottom) + ", the sheet at " +
                       std::to_string(layout.width) + ", " + std::to_string(layout.height));
  }
  return Status::ok();
}

}  // namespace burnish
