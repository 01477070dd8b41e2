#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "client/pages/page_item.h"
#include "client/scene/page_texture.h"
#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/pages/page_grid.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"
#include "common/sheets/webp_header.h"

namespace burnish {

/// A sheet of a page as it came, and what it must be by the directory.
struct EncodedTexture {
  PageItem sheet;
  std::shared_ptr<const Page> page;
  std::vector<uint8_t> chart_bytes;
  std::vector<uint8_t> sheet_bytes;
  TexelSize size;     ///< texels
  float density = 0;  ///< texels per file unit
};

/// The same with all checked but the texels.
struct OpenedTexture {
  PageItem item;
  std::shared_ptr<const Page> page;
  PageCharts charts;
  Sheet sheet;  ///< without its texels
  SheetCodec codec = SheetCodec::kLossyWebp;
  std::vector<uint8_t> webp;  ///< opaque_webp() of the sheet's size
};

struct DecodedTexture {
  PageItem sheet;
  std::shared_ptr<const PageTexture> texture;  ///< null: it failed
  Status status = Status::ok();
  PageItem damaged;  ///< the record, if it failed
};

/// Checks that charts and a sheet fit each other, the page and the directory. Decodes no texel.
/// Safe for any bytes. Fails: data_loss or unimplemented; `damaged` is then the record.
Result<OpenedTexture> open_texture(const EncodedTexture& encoded, const PageGrid& grid,
                                   PageItem& damaged);

/// Returns the texture, or why the texels do not decode. Shapes: one per texel of the sheet.
DecodedTexture finish_texture(OpenedTexture opened, Result<std::vector<Rgba8>> texels,
                              const PageGrid& grid);

/// Returns a sheet as pictures need it. Needs: check_sheet_layout() is ok.
PageTexture make_page_texture(const Page& page, const PageCharts& charts, Sheet sheet,
                              const PageGrid& grid);

}  // namespace burnish
