#include "server/prepare/sheets/page_sheets.h"

#include <algorithm>
#include <utility>

#include "common/base/line_text.h"
#include "common/sheets/cut_charts.h"
#include "common/sheets/sheet_density.h"
#include "common/sheets/sheet_limits.h"
#include "common/sheets/sheet_source.h"
#include "server/prepare/pages/page_texels.h"

namespace burnish {

namespace {

constexpr float kDensityMin = 0x1p-100f;  // its halves are floats too

Status check_density(double density) {
  if (density >= kDensityMin && density < kSheetDensityEnd) return Status::ok();
  LineText message;
  message << "sheets of " << density << " texels per file unit: the density must be within "
          << kDensityMin << ".." << kSheetDensityEnd;
  return invalid_argument(message.text());
}

/// Asks again and again while a source is drawn.
BakeSource heard(BakeSource source, const std::function<void()>& ask) {
  constexpr uint32_t kTexelsBetween = 2048;
  source.texel = [texel = std::move(source.texel), &ask, left = kTexelsBetween](
                     uint32_t triangle, const Vec3d& weights) mutable {
    if (--left == 0) {
      left = kTexelsBetween;
      ask();
    }
    return texel(triangle, weights);
  };
  return source;
}

/// Lays a sheet out. Its density is a float, as files and clients have it.
Sheet laid_out(const Page& page, const PageCharts& charts, double density, double step) {
  Sheet sheet{.page = page.id, .density = static_cast<float>(density)};
  for (;;) {
    FittedSheet fitted = fit_sheet(page, charts, sheet.density * step);
    sheet.layout = std::move(fitted.layout);
    if (fitted.texels_per_step == sheet.density * step) return sheet;
    sheet.density = static_cast<float>(fitted.texels_per_step / step);
  }
}

void bake(Sheet& sheet, const Page& page, const PageCharts& charts, int samples_per_side,
          const PageSheetsWish& wish, BakeSource source) {
  wish.ask();
  sheet.texels =
      bake_sheet(page, charts, {sheet.layout, sheet.density * wish.step, samples_per_side},
                 heard(std::move(source), wish.ask));
}

}  // namespace

uint64_t PageSheets::texels() const {
  uint64_t sum = 0;
  for (const Sheet& sheet : sheets) sum += sheet.layout.texels();
  return sum;
}

double page_area(const Page& page, double step) {
  double area = 0;
  for (const PageTriangle& t : page.triangles) {
    const Vec3d origin = page.positions[t[0]].cast<double>();
    const Vec3d a = page.positions[t[1]].cast<double>() - origin;
    const Vec3d b = page.positions[t[2]].cast<double>() - origin;
    area += a.cross(b).norm() / 2;
  }
  const auto triangles = static_cast<double>(page.triangles.size());
  return std::max(area, kTriangleAreaMin * triangles) * step * step;
}

Result<PageSheets> make_page_sheets(const Page& page, const PageSheetsWish& wish) {
  RETURN_IF_ERROR(check_density(wish.density));
  PageSheets made;
  made.charts = cut_charts(page, static_cast<float>(wish.density) * wish.step);
  Sheet finest = laid_out(page, made.charts, wish.density, wish.step);
  RETURN_IF_ERROR(check_density(finest.density));
  ASSIGN_OR_RETURN(BakeSource source, wish.source(finest.density));
  bake(finest, page, made.charts, wish.samples_per_side, wish, std::move(source));
  const size_t count =
      std::min(sheet_count(finest.density, page.triangles.size(), page_area(page, wish.step)),
               wish.sheets_max);
  made.sheets.reserve(count);
  made.sheets.push_back(std::move(finest));
  for (uint8_t halving = 1; halving < count; ++halving) {
    const SheetedPage finer = {&page, &made.charts, &made.sheets.back()};
    Sheet half = laid_out(page, made.charts, made.sheets.back().density / 2, wish.step);
    if (half.density * 2 != finer.sheet->density) break;  // gutters fill it
    half.halving = halving;
    bake(half, page, made.charts, 2, wish, source_of_sheets({&finer, 1}, wish.step));
    made.sheets.push_back(std::move(half));
  }
  return made;
}

}  // namespace burnish
