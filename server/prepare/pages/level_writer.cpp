#include "server/prepare/pages/level_writer.h"

#include <algorithm>

#include "common/pages/page_codec.h"

namespace burnish {

Status LevelWriter::write(const LevelToDraw& level, const std::vector<Replacement>& replacements,
                          const PageWork& work, PagesReport::Level& report) {
  const size_t pages = level.cut.pages.count();
  const PageId first = file_.next_page();
  std::vector<DrawnPage> drawn(pages);
  AttributeSums sums(level.shared, level.cut.joined, pages);
  file_.begin_level();
  const auto make = [&](size_t page) {
    drawn[page].page = draw_page(level, page, first + static_cast<PageId>(page));
    drawn[page].encoded = encode_page(drawn[page].page);
    sums.take(page, sum_page(level.cut, attributes_, vertices_.positions, page), attributes_);
  };
  const auto take = [&](size_t page) {
    const Status status = append(drawn[page], bounds_of(drawn[page], replacements, page), report);
    drawn[page] = {};
    return status;
  };
  RETURN_IF_ERROR(work.run(pages, make, take));
  sums.set_shared(attributes_);
  return Status::ok();
}

// Nothing replaces the root. Its error and edge say that it is never good enough by itself.
PageBounds LevelWriter::bounds_of(const DrawnPage& drawn,
                                  const std::vector<Replacement>& replacements, size_t page) const {
  PageBounds bounds = sphere_around(drawn.page, vertices_.grid);
  bounds.error = replacements.empty() ? bounds.radius : replacements[page].error;
  bounds.edge =
      replacements.empty() ? bounds.radius : mean_edge(replacements[page].triangles, vertices_);
  for (const PagePatch& patch : drawn.page.patches) {
    if (patch.finer == kNoPage) continue;
    bounds.error = std::max(bounds.error, bounds_[patch.finer].error);
    bounds.edge = std::max(bounds.edge, bounds_[patch.finer].edge);
  }
  return bounds;
}

Status LevelWriter::append(const DrawnPage& drawn, const PageBounds& bounds,
                           PagesReport::Level& report) {
  bounds_.push_back(bounds);
  report.vertices += drawn.page.positions.size();
  report.border_vertices += drawn.page.border_vertices;
  report.bytes += drawn.encoded.size();
  return file_.add(drawn.page, bounds, drawn.encoded);
}

}  // namespace burnish
