#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page_file.h"
#include "server/prepare/sheets/build_sheets.h"
#include "server/prepare/sheets/level_sheets.h"
#include "server/prepare/sheets/page_sheets.h"
#include "server/prepare/sheets/picture_tiles.h"
#include "server/prepare/sheets/triangle_finder.h"

namespace burnish {

/// The sheets of a page on their way to the file.
struct EncodedPage {
  std::vector<uint8_t> charts;
  std::vector<std::vector<uint8_t>> sheets;
  Status status;
  uint64_t texels = 0;
  double used_texels = 0;
  uint64_t lost_triangles = 0;
};

/// Makes the sheets of pages, of level 0 and of those above. Threads may make different pages at
/// the same time.
class PageMaker {
 public:
  /// Needs: the arguments outlive this.
  PageMaker(const SheetsInput& scan, const PictureTiles& tiles, const TriangleFinder& finder)
      : scan_(scan),
        tiles_(tiles),
        finder_(finder),
        step_(scan.pages.directory().head.grid.step()) {}

  /// `finer`: the level below; null at level 0. `made` keeps the page's sheets. `ask` is called
  /// often. Throws: what `ask` throws.
  EncodedPage make(PageId id, const LevelSheets* finer, LevelSheets& made,
                   const std::function<void()>& ask) const;

 private:
  Status fill(EncodedPage& encoded, PageId id, const LevelSheets* finer, LevelSheets& made,
              const std::function<void()>& ask) const;
  Result<PageSheets> paint(EncodedPage& encoded, const Page& page,
                           const std::function<void()>& ask) const;
  Result<PageSheets> join(const Page& page, const LevelSheets& finer,
                          const std::function<void()>& ask) const;

  const SheetsInput& scan_;
  const PictureTiles& tiles_;
  const TriangleFinder& finder_;
  const double step_;
};

}  // namespace burnish
