#include "client/sheets/opened_texture.h"

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

PageTexture make_page_texture(const Page& page, const PageCharts& charts, Sheet sheet,
                              const PageGrid& grid) {
  PageTexture texture;
  texture.chart_of_triangle = charts.of_triangle;
  for (uint32_t end = 0; const PagePatch& patch : page.patches)
    texture.patch_ends.push_back(end += patch.triangles);
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

// The record is damaged in itself, or it is not the one that was asked for.
static Result<OpenedTexture> open_checked(const EncodedTexture& encoded, PageCharts charts,
                                          const PageGrid& grid) {
  ASSIGN_OR_RETURN(SheetRecord record, open_sheet(encoded.sheet_bytes));
  const SheetHeader& header = record.header;
  ASSIGN_OR_RETURN(std::vector<uint8_t> webp,
                   opaque_webp(record.webp, header.width, header.height, header.codec));
  Sheet sheet{header.page, header.halving, header.density, std::move(record.layout), {}};
  RETURN_IF_ERROR(check_against_directory(encoded, sheet));
  RETURN_IF_ERROR(
      check_sheet_layout(sheet.layout, *encoded.page, charts, sheet.density * grid.step()));
  return OpenedTexture{encoded.sheet,    encoded.page, std::move(charts),
                       std::move(sheet), header.codec, std::move(webp)};
}

Result<OpenedTexture> open_texture(const EncodedTexture& encoded, const PageGrid& grid,
                                   PageItem& damaged) {
  damaged = PageItem::of_charts(encoded.sheet.number, encoded.sheet.version);
  ASSIGN_OR_RETURN(PageCharts charts, decode_charts(encoded.chart_bytes, *encoded.page));
  damaged = encoded.sheet;
  return open_checked(encoded, std::move(charts), grid);
}

DecodedTexture finish_texture(OpenedTexture opened, Result<std::vector<Rgba8>> texels,
                              const PageGrid& grid) {
  if (!texels.is_ok()) return {opened.item, nullptr, texels.status(), opened.item};
  const PageItem item = opened.item;
  opened.sheet.texels = std::move(*texels);
  PageTexture texture =
      make_page_texture(*opened.page, opened.charts, std::move(opened.sheet), grid);
  return {item, std::make_shared<const PageTexture>(std::move(texture)), Status::ok(), {}};
}

}  // namespace burnish
