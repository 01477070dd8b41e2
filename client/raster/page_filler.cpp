#include "client/raster/page_filler.h"

#include <array>

#include "client/raster/near_clip.h"
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

  void fill(const RasterPage& page, std::span<const PatchRange> patches) const {
    const RasterSurface& surface = page.surface(part_.of_original);
    if (surface.positions.empty()) return;
    if (project_box(projection_, surface.box, part_.columns).is_empty()) return;
    std::array<ScreenVertex, kPageVerticesMax> seen;
    project_vertices(projection_, surface.positions, seen.data());
    for (const PatchRange& patch : patches) fill_patch(page, surface, seen.data(), patch);
  }

 private:
  void fill_patch(const RasterPage& page, const RasterSurface& surface, const ScreenVertex* seen,
                  const PatchRange& patch) const {
    std::array<uint16_t, kPageTrianglesMax> left;
    const ScreenTriangles triangles{seen,
                                    std::span(page.triangles).subspan(patch.first, patch.count),
                                    triangle_id(patch.slot, patch.first)};
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

void fill_pages(std::span<const RasterPage> pages, const PageProjection& projection,
                std::span<const PatchRange> patches, const FilledPart& part, WorkCrew& crew,
                Visibility& visibility) {
  if (part.columns.first >= part.columns.end) return;
  const std::vector<std::span<const PatchRange>> groups = by_page(patches);
  const PageFiller filler(projection, part, crew.threads() > 1, visibility);
  crew.run(static_cast<int>(groups.size()),
           [&](int i) { filler.fill(pages[groups[i].front().slot], groups[i]); });
}

}  // namespace burnish
