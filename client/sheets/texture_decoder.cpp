#include "client/sheets/texture_decoder.h"

#include <string>
#include <utility>

#include "common/sheets/chart_codec.h"
#include "common/sheets/sheet_codec.h"

namespace burnish {

// A position in PageSpace is (2 step + 1) / steps - 1.
static Eigen::Vector4f in_page_space(const Vec3d& per_step, double offset, int steps) {
  Eigen::Vector4f row;
  row.head<3>() = (per_step * (0.5 * steps)).cast<float>();
  row.w() = static_cast<float>(offset + per_step.sum() * 0.5 * (steps - 1));
  return row;
}

PageTexture make_page_texture(const PageCharts& charts, Sheet sheet, const PageGrid& grid) {
  PageTexture texture;
  texture.chart_of_triangle = charts.of_triangle;
  for (size_t c = 0; c < charts.charts.size(); ++c) {
    const ChartMapping mapping =
        chart_mapping(charts.charts[c], sheet.density * grid.step(), sheet.layout.places[c]);
    texture.charts.push_back({in_page_space(mapping.u, mapping.x, grid.steps()),
                              in_page_space(mapping.v, mapping.y, grid.steps())});
  }
  texture.levels = texture_levels(sheet.layout.width, sheet.layout.height, std::move(sheet.texels));
  return texture;
}

static Status check_against_directory(const EncodedTexture& encoded, const Sheet& sheet) {
  const std::string name = "the sheet of page " + std::to_string(sheet.page) + ", halving " +
                           std::to_string(sheet.halving);
  if (sheet.page != encoded.sheet.number || sheet.halving != encoded.sheet.halving)
    return data_loss(name + " came for page " + std::to_string(encoded.sheet.number) +
                     ", halving " + std::to_string(encoded.sheet.halving));
  if (sheet.layout.width != encoded.size.width || sheet.layout.height != encoded.size.height)
    return data_loss(name + " has " + std::to_string(sheet.layout.width) + "x" +
                     std::to_string(sheet.layout.height) + " texels: the directory lists " +
                     std::to_string(encoded.size.width) + "x" +
                     std::to_string(encoded.size.height));
  if (sheet.density != encoded.density)
    return data_loss(name + " has a density of " + std::to_string(sheet.density) +
                     ": the directory says " + std::to_string(encoded.density));
  return Status::ok();
}

DecodedTexture decode_texture(const EncodedTexture& encoded, const PageGrid& grid) {
  DecodedTexture decoded;
  decoded.sheet = encoded.sheet;
  const auto fail = [&](const Status& why, PageItem damaged) {
    decoded.status = why;
    decoded.damaged = damaged;
    return decoded;
  };
  const Result<PageCharts> charts = decode_charts(encoded.chart_bytes, *encoded.page);
  if (!charts.is_ok()) return fail(charts.status(), PageItem::of_charts(encoded.sheet.number));
  Result<Sheet> sheet = decode_sheet(encoded.sheet_bytes);
  if (!sheet.is_ok()) return fail(sheet.status(), encoded.sheet);
  const Status listed = check_against_directory(encoded, *sheet);
  if (!listed.is_ok()) return fail(listed, encoded.sheet);
  const Status fits =
      check_sheet_layout(sheet->layout, *encoded.page, *charts, sheet->density * grid.step());
  if (!fits.is_ok()) return fail(fits, encoded.sheet);
  decoded.texture =
      std::make_shared<const PageTexture>(make_page_texture(*charts, std::move(*sheet), grid));
  return decoded;
}

}  // namespace burnish
