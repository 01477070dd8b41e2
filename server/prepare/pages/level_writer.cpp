#include "server/prepare/pages/level_writer.h"

#include <algorithm>

#include "common/pages/page_codec.h"

namespace burnish {

Status LevelWriter::write(const LevelToDraw& level, const Replacements& replacements,
                          const PageWork& work, const ScratchSpace& space,
                          PagesReport::Level& report) {
  const size_t pages = level.cut.pages.count();
  const PageId first = file_.next_page();
  std::vector<DrawnPage> batch(std::min(pages, PageWork::kPagesPerBatch));
  AttributeSums sums(level.shared, level.cut.joined, space);
  file_.begin_level();
  const auto make = [&](size_t page) {
    DrawnPage& drawn = batch[page % batch.size()];
    drawn.page = draw_page(level, page, first + static_cast<PageId>(page));
    drawn.encoded = encode_page(drawn.page);
    drawn.sums = sum_page(level.cut, attributes_, vertices_.positions, page);
    sums.set_own(drawn.sums, attributes_);
  };
  const auto take = [&](size_t page) {
    const DrawnPage& drawn = batch[page % batch.size()];
    sums.keep_shared(drawn.sums);
    return append(drawn, bounds_of(drawn, replacements, page), report);
  };
  RETURN_IF_ERROR(work.run(pages, make, take));
  sums.set_shared(attributes_, work.end());
  return Status::ok();
}

// Nothing replaces the root. Its error and edge say that it is never good enough by itself.
PageBounds LevelWriter::bounds_of(const DrawnPage& drawn, const Replacements& replacements,
                                  size_t page) const {
  PageBounds bounds = sphere_around(drawn.page, vertices_.grid);
  const bool is_root = replacements.of_pages.empty();
  bounds.error = is_root ? bounds.radius : replacements.of_pages[page].error;
  bounds.edge = is_root ? bounds.radius : mean_edge(replacements.of(page), vertices_);
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
