#include "common/sheets/sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/sheets/sheet_limits.h"

namespace burnish {

namespace {

/// A level piece of the skyline. The next one begins where it ends.
struct SkylinePiece {
  uint32_t x;
  uint32_t y;  ///< free from here on
};

/// The outline of what is taken of a sheet of one width.
class Skyline {
 public:
  explicit Skyline(uint32_t width) : width_(width), pieces_{{0, 0}} {}

  /// Takes the place where the rectangle ends lowest, the leftmost of several. Returns nothing if
  /// it ends beyond kSheetSideMax. Needs: it is not wider than the sheet.
  std::optional<TexelPlace> take(const TexelSize& size) {
    size_t best = pieces_.size();
    uint32_t best_y = kSheetSideMax;
    for (size_t i = 0; i < pieces_.size() && pieces_[i].x + size.width <= width_; ++i) {
      const uint32_t y = level_under(i, size.width);
      if (y + size.height > kSheetSideMax || (best < pieces_.size() && y >= best_y)) continue;
      best = i;
      best_y = y;
    }
    if (best == pieces_.size()) return std::nullopt;
    const uint32_t x = pieces_[best].x;
    raise(best, size.width, best_y + size.height);
    return TexelPlace{static_cast<uint16_t>(x), static_cast<uint16_t>(best_y)};
  }

 private:
  uint32_t end_of(size_t piece) const {
    return piece + 1 < pieces_.size() ? pieces_[piece + 1].x : width_;
  }

  uint32_t level_under(size_t first, uint32_t width) const {
    uint32_t level = 0;
    for (size_t i = first; i < pieces_.size() && pieces_[i].x < pieces_[first].x + width; ++i)
      level = std::max(level, pieces_[i].y);
    return level;
  }

  void raise(size_t first, uint32_t width, uint32_t level) {
    const uint32_t begin = pieces_[first].x;
    const uint32_t end = begin + width;
    size_t last = first;  // the piece that has the end
    while (end_of(last) < end) ++last;
    std::vector<SkylinePiece> raised = {{begin, level}};
    if (end < end_of(last)) raised.push_back({end, pieces_[last].y});
    const auto at = pieces_.begin();
    const auto next = pieces_.erase(at + static_cast<std::ptrdiff_t>(first),
                                    at + static_cast<std::ptrdiff_t>(last + 1));
    pieces_.insert(next, raised.begin(), raised.end());
  }

  const uint32_t width_;
  std::vector<SkylinePiece> pieces_;
};

std::vector<uint32_t> highest_first(std::span<const TexelSize> sizes) {
  std::vector<uint32_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) {
    if (sizes[a].height != sizes[b].height) return sizes[a].height > sizes[b].height;
    return sizes[a].width > sizes[b].width;
  });
  return order;
}

std::optional<SheetLayout> pack(std::span<const TexelSize> sizes, std::span<const uint32_t> order,
                                uint32_t width) {
  Skyline skyline(width);
  SheetLayout layout{.places = std::vector<TexelPlace>(sizes.size())};
  for (const uint32_t chart : order) {
    const auto place = skyline.take(sizes[chart]);
    if (!place) return std::nullopt;
    layout.places[chart] = *place;
    layout.width =
        static_cast<uint16_t>(std::max<uint32_t>(layout.width, place->x + sizes[chart].width));
    layout.height =
        static_cast<uint16_t>(std::max<uint32_t>(layout.height, place->y + sizes[chart].height));
  }
  return layout;
}

/// Returns widths around that of a full square, and the widest.
std::vector<uint32_t> widths_to_try(std::span<const TexelSize> sizes) {
  double area = 0;
  uint32_t widest = 1;
  for (const TexelSize& size : sizes) {
    area += static_cast<double>(size.width) * size.height;
    widest = std::max(widest, size.width);
  }
  std::vector<uint32_t> widths;
  if (widest > kSheetSideMax) return widths;
  for (const double part : {0.7, 0.8, 0.9, 1.0, 1.05, 1.1, 1.15, 1.2, 1.3, 1.4, 1.6})
    widths.push_back(static_cast<uint32_t>(
        std::clamp<double>(std::ceil(part * std::sqrt(area)), widest, kSheetSideMax)));
  widths.push_back(kSheetSideMax);
  const auto repeated = std::ranges::unique(widths);
  widths.erase(repeated.begin(), repeated.end());
  return widths;
}

uint32_t side_texels(double extent, double texels_per_step) {
  constexpr double kFarBeyond = 65536;
  return static_cast<uint32_t>(
      std::min(std::ceil(extent * texels_per_step) + kChartTexelsMin, kFarBeyond));
}

}  // namespace

std::vector<TexelSize> chart_sizes(const Page& page, const PageCharts& charts,
                                   double texels_per_step) {
  std::vector<TexelSize> sizes;
  for (const ChartExtent& extent : chart_extents(page, charts))
    sizes.push_back(
        {side_texels(extent.u, texels_per_step), side_texels(extent.v, texels_per_step)});
  return sizes;
}

std::optional<SheetLayout> lay_out_sheet(std::span<const TexelSize> sizes) {
  const std::vector<uint32_t> order = highest_first(sizes);
  std::optional<SheetLayout> best;
  for (const uint32_t width : widths_to_try(sizes)) {
    auto layout = pack(sizes, order, width);
    if (layout && (!best || layout->texels() < best->texels())) best = std::move(layout);
  }
  return best;
}

ChartMapping chart_mapping(const Chart& chart, double texels_per_step, const TexelPlace& place) {
  const ChartAxes axes = axes_of(chart);
  constexpr double kFirstCentre = kSheetGutter + 0.5;
  return {axes.u * texels_per_step, axes.v * texels_per_step, axes.normal * texels_per_step,
          place.x + kFirstCentre - chart.least[0] * texels_per_step,
          place.y + kFirstCentre - chart.least[1] * texels_per_step};
}

}  // namespace burnish
