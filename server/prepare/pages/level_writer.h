#pragma once

#include <vector>

#include "common/pages/page_file.h"
#include "server/prepare/pages/draw_page.h"
#include "server/prepare/pages/page_work.h"
#include "server/prepare/pages/pages_report.h"
#include "server/prepare/pages/replace_pages.h"

namespace burnish {

/// Draws and encodes the pages of a scan level by level, and writes them to its page file.
class LevelWriter {
 public:
  LevelWriter(PageFileWriter& file, const PageVertices& vertices, VertexAttributes& attributes)
      : file_(file), vertices_(vertices), attributes_(attributes) {}

  /// Writes one level, and turns the attributes into those of the next one.
  /// Needs: the finer levels are written. No replacements for the root alone.
  /// Fails: cancelled; what writing says.
  Status write(const LevelToDraw& level, const Replacements& replacements, const PageWork& work,
               const ScratchSpace& space, PagesReport::Level& report);

 private:
  struct DrawnPage {
    Page page;
    std::vector<uint8_t> encoded;
    PageSums sums;
  };
  PageBounds bounds_of(const DrawnPage& drawn, const Replacements& replacements, size_t page) const;
  Status append(const DrawnPage& drawn, const PageBounds& bounds, PagesReport::Level& report);

  PageFileWriter& file_;
  const PageVertices& vertices_;
  VertexAttributes& attributes_;
  std::vector<PageBounds> bounds_;  ///< of all pages that are written
};

}  // namespace burnish
