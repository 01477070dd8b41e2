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

struct DecodedTexture {
  PageItem sheet;
  std::shared_ptr<const PageTexture> texture;  ///< null: it failed
  Status status = Status::ok();
  PageItem damaged;  ///< the record, if it failed
};

/// Decodes charts and a sheet, and checks that they fit the page and the directory. Safe for any
/// bytes.
DecodedTexture decode_texture(const EncodedTexture& encoded, const PageGrid& grid);

/// Returns a sheet as pictures need it. Needs: check_sheet_layout() is ok.
PageTexture make_page_texture(const PageCharts& charts, Sheet sheet, const PageGrid& grid);

}  // namespace burnish
