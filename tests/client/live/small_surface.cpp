#include "tests/client/live/small_surface.h"

#include <algorithm>

#include "common/page_frames/page_corners.h"

namespace burnish {

PageHead small_head() {
  PageHead head;
  head.grid = small_pages().lattice;
  head.level_pages = {static_cast<uint32_t>(small_pages().pages.size())};
  return head;
}

int small_depth() {
  return small_pages().grid.depth;
}

std::shared_ptr<const Page> small_page(PageId page) {
  return std::make_shared<const Page>(small_pages().pages[page]);
}

std::vector<std::shared_ptr<const Page>> small_pages_of(const std::vector<PageId>& pages) {
  std::vector<std::shared_ptr<const Page>> list;
  for (const PageId page : pages) list.push_back(small_page(page));
  return list;
}

static std::vector<Vec3f> sampled(std::span<const int32_t> steps) {
  std::vector<Vec3f> values(steps.size() / 3);
  for (size_t i = 0; i < values.size(); ++i)
    for (size_t axis = 0; axis < 3; ++axis)
      values[i][static_cast<int>(axis)] =
          static_cast<float>(steps[axis * values.size() + i]) / 256.0f;
  return values;
}

std::vector<Vec3f> moved(const PageSampler& sampler, PageId page) {
  const std::vector<Vec3f> values = sampled(sampler.steps(page));
  if (sampler.kind() == PageFrameKind::kVertices) return values;
  const std::vector<Vec3i>& positions = small_pages().pages[page].positions;
  const int bits = small_pages().lattice.bits;
  std::vector<Vec3f> displacements(positions.size());
  evaluate_page(make_page_corners(positions, bits, small_depth()), positions, bits, small_depth(),
                values, displacements);
  return displacements;
}

bool shows(const SurfaceFrame& frame, const PageSampler& sampler,
           const std::vector<PageId>& pages) {
  return frame.pages == pages && std::ranges::all_of(pages, [&](PageId page) {
           return frame.find(page)->displacements == moved(sampler, page);
         });
}

}  // namespace burnish
