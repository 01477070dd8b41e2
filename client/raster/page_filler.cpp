#include "client/raster/page_filler.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "client/raster/near_clip.h"
#include "client/raster/nearness_tiles.h"
#include "client/raster/triangle_filler.h"
#include "common/base/limits.h"

namespace burnish {
namespace {

/// Patches that follow each other and are of one page, so that its vertices are projected once.
std::vector<std::span<const PatchRange>> by_page(std::span<const PatchRange> patches) {
  std::vector<std::span<const PatchRange>> groups;
  for (size_t first = 0, i = 1; i <= patches.size(); ++i) {
    if (i < patches.size() && patches[i].slot == patches[first].slot) continue;
    groups.push_back(patches.subspan(first, i - first));
    first = i;
  }
  return groups;
}

/// Fills pages on one thread of several.
class PageFiller {
 public:
  PageFiller(const PageProjection& projection, const FilledPart& part, bool is_shared,
             Visibility& visibility)
      : projection_(projection), part_(part), is_shared_(is_shared), visibility_(visibility) {}

  /// `tiles`: null where nothing is known to be hidden.
  void fill(const RasterPage& page, std::span<const PatchRange> patches,
            const NearnessTiles* tiles) const {
    const RasterSurface& surface = page.surface(part_.of_original);
    std::array<ScreenVertex, kPageVerticesMax> seen;
    project_vertices(projection_, surface.positions, seen.data());
    for (const PatchRange& patch : patches)
      for_each_run(patch, [&](const PatchRange& run) {
        if (!is_hidden(surface.run_boxes[run.first / kRunTriangles], tiles))
          fill_run(page, surface, seen.data(), run);
      });
  }

 private:
  template <typename Visit>
  static void for_each_run(const PatchRange& patch, const Visit& visit) {
    const uint32_t end = patch.first + patch.count;
    for (uint32_t first = patch.first; first < end;) {
      const uint32_t next = std::min((first / kRunTriangles + 1) * kRunTriangles, end);
      visit(PatchRange{patch.slot, first, next - first});
      first = next;
    }
  }

  bool is_hidden(const Eigen::AlignedBox3f& box, const NearnessTiles* tiles) const {
    if (tiles == nullptr) return false;
    const ScreenBox seen = project_box(projection_, box, part_.columns);
    return seen.is_empty() || tiles->hide(seen);
  }

  void fill_run(const RasterPage& page, const RasterSurface& surface, const ScreenVertex* seen,
                const PatchRange& run) const {
    std::array<uint16_t, kRunTriangles> left;
    const ScreenTriangles triangles{seen, std::span(page.triangles).subspan(run.first, run.count),
                                    triangle_id(run.slot, run.first)};
    const int count =
        fill_triangles(visibility_, part_.columns, is_shared_, triangles, left.data());
    for (int i = 0; i < count; ++i) {
      const auto [a, b, c] = triangles.triangles[left[i]];
      const auto& at = surface.positions;
      fill_clipped(visibility_, projection_, part_.columns, is_shared_, {at[a], at[b], at[c]},
                   {seen[a], seen[b], seen[c]}, triangles.first_id + left[i]);
    }
  }

  const PageProjection& projection_;
  const FilledPart& part_;
  bool is_shared_;
  Visibility& visibility_;
};

}  // namespace

namespace {

/// A page whose box is in the picture.
struct PageInView {
  const RasterPage* page;
  std::span<const PatchRange> patches;
  ScreenBox box;
  bool faces_eye;
};

std::vector<PageInView> pages_in_view(std::span<const RasterPage> pages,
                                      const PageProjection& projection,
                                      std::span<const PatchRange> patches, const FilledPart& part) {
  std::vector<PageInView> found;
  for (const auto& group : by_page(patches)) {
    const RasterPage& page = pages[group.front().slot];
    const RasterSurface& surface = page.surface(part.of_original);
    if (surface.positions.empty()) continue;
    const ScreenBox box = project_box(projection, surface.box, part.columns);
    if (box.is_empty()) continue;
    const bool faces_eye = surface.mean_normal.dot(projection.to_eye(surface.box.center())) > 0;
    found.push_back({&page, group, box, faces_eye});
  }
  return found;
}

}  // namespace

// Pages that face the eye come first, the nearest before the others. Most of the rest is behind
// them, and falls out as a whole. The picture is the same in any order.
void fill_pages(std::span<const RasterPage> pages, const PageProjection& projection,
                std::span<const PatchRange> patches, const FilledPart& part, WorkCrew& crew,
                Visibility& visibility) {
  if (part.columns.first >= part.columns.end) return;
  std::vector<PageInView> seen = pages_in_view(pages, projection, patches, part);
  std::ranges::stable_sort(seen, [](const PageInView& a, const PageInView& b) {
    return std::pair(a.faces_eye, a.box.nearness) > std::pair(b.faces_eye, b.box.nearness);
  });
  const auto turned_away =
      std::ranges::find_if(seen, [](const PageInView& page) { return !page.faces_eye; });
  const PageFiller filler(projection, part, crew.threads() > 1, visibility);
  const int facing = static_cast<int>(turned_away - seen.begin());
  crew.run(facing, [&](int i) { filler.fill(*seen[i].page, seen[i].patches, nullptr); });
  if (turned_away == seen.end()) return;
  NearnessTiles tiles;
  tiles.measure(visibility, crew);
  crew.run(static_cast<int>(seen.size()) - facing, [&](int i) {
    const PageInView& page = seen[facing + i];
    if (!tiles.hide(page.box)) filler.fill(*page.page, page.patches, &tiles);
  });
}

}  // namespace burnish
