#include "client/scene/page_rims.h"

#include <algorithm>
#include <tuple>

#include "client/scene/page_normals.h"

namespace burnish {

static std::span<const PageTriangle> triangles_of(const PageMesh& mesh, const PatchRange& range) {
  return std::span(mesh.triangles).subspan(range.first, range.count);
}

static size_t count_triangles(std::span<const PatchRange> drawn) {
  size_t count = 0;
  for (const PatchRange& range : drawn) count += range.count;
  return count;
}

PageRim find_rim(const PageMesh& mesh, std::span<const PatchRange> drawn) {
  std::vector<uint32_t> uses(mesh.positions.size()), drawn_uses(uses.size());
  const bool is_partial = count_triangles(drawn) < mesh.triangles.size();
  if (is_partial) {
    for (const PageTriangle& triangle : mesh.triangles)
      for (const uint16_t vertex : triangle) ++uses[vertex];
    for (const PatchRange& range : drawn)
      for (const PageTriangle& triangle : triangles_of(mesh, range))
        for (const uint16_t vertex : triangle) ++drawn_uses[vertex];
  }
  PageRim rim;
  for (size_t v = 0; v < uses.size(); ++v) {
    const bool is_border = v < mesh.border_vertices && (!is_partial || drawn_uses[v] > 0);
    const bool is_between = drawn_uses[v] > 0 && drawn_uses[v] < uses[v];
    if (is_border || is_between) rim.push_back(static_cast<uint16_t>(v));
  }
  return rim;
}

std::vector<Vec3f> sum_rim_normals(std::span<const Vec3f> positions, const PageMesh& mesh,
                                   std::span<const PatchRange> drawn, const PageRim& rim) {
  std::vector<Vec3f> sums(rim.size(), Vec3f::Zero());
  for (const PatchRange& range : drawn) {
    const auto of_range = sum_corner_normals(positions, triangles_of(mesh, range));
    for (size_t i = 0; i < rim.size(); ++i) sums[i] += of_range[rim[i]];
  }
  return sums;
}

namespace {

struct PlacedRim {
  Vec3f position;
  RimPlace place;

  auto order() const {
    return std::tuple(position.x(), position.y(), position.z(), place.page, place.index);
  }
};

}  // namespace

static std::vector<PlacedRim> sorted_rims(std::span<const RimmedPage> pages) {
  std::vector<PlacedRim> placed;
  for (uint32_t page = 0; page < pages.size(); ++page) {
    const auto& [mesh, rim] = pages[page];
    for (uint32_t i = 0; i < rim->size(); ++i)
      placed.push_back({mesh->positions[(*rim)[i]], {page, i}});
  }
  std::ranges::sort(placed, {}, &PlacedRim::order);
  return placed;
}

Groups<RimPlace> group_rims(std::span<const RimmedPage> pages) {
  Groups<RimPlace> groups;
  std::vector<RimPlace> group;
  const std::vector<PlacedRim> placed = sorted_rims(pages);
  for (size_t i = 0; i < placed.size(); ++i) {
    group.push_back(placed[i].place);
    if (i + 1 < placed.size() && placed[i + 1].position == placed[i].position) continue;
    if (group.size() > 1) groups.add(group);
    group.clear();
  }
  return groups;
}

}  // namespace burnish
