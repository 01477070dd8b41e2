#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/pages/page.h"
#include "common/sheets/chart.h"

namespace burnish {

/// Sides of a rectangle of texels.
struct TexelSize {
  uint32_t width = 0;
  uint32_t height = 0;
  bool operator==(const TexelSize&) const = default;
};

/// The texel at a rectangle's corner.
struct TexelPlace {
  uint16_t x = 0;
  uint16_t y = 0;
  bool operator==(const TexelPlace&) const = default;
};

/// The place of each chart of a page on a sheet, with its gutter.
struct SheetLayout {
  uint16_t width = 0;   ///< texels
  uint16_t height = 0;  ///< texels
  std::vector<TexelPlace> places;

  size_t texels() const { return size_t{width} * height; }
  bool operator==(const SheetLayout&) const = default;
};

/// Returns the texels that each chart takes with its gutter: kChartTexelsMin a side at least. A
/// side that is too large for any sheet is cut to 2^16.
std::vector<TexelSize> chart_sizes(const Page& page, const PageCharts& charts,
                                   double texels_per_step);

/// Packs rectangles without overlap by a skyline: each, from the highest to the lowest, goes where
/// its upper side comes lowest (Jylänki, "A Thousand Ways to Pack the Bin", 2010). Tries several
/// widths and takes the smallest sheet. Returns nothing if the rectangles do not fit into
/// kSheetSideMax². The same sizes give the same layout.
std::optional<SheetLayout> lay_out_sheet(std::span<const TexelSize> sizes);

/// Maps a position in steps to texels of a sheet: texel i has its centre at i + 1/2.
struct ChartMapping {
  Vec3d u;  ///< texels per step
  Vec3d v;
  Vec3d normal;  ///< texels per step too, so that depths are in texels
  double x = 0;  ///< texels
  double y = 0;

  Vec2d texel(const Vec3d& position) const { return {u.dot(position) + x, v.dot(position) + y}; }
};
ChartMapping chart_mapping(const Chart& chart, double texels_per_step, const TexelPlace& place);

}  // namespace burnish
