#include "client/scene/page_rims.h"

#include <bit>

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

std::vector<PageTriangle> triangles_at_rim(const PageMesh& mesh, std::span<const PatchRange> drawn,
                                           const PageRim& rim) {
  std::vector<uint8_t> is_rim(mesh.positions.size());
  for (const uint16_t vertex : rim) is_rim[vertex] = 1;
  std::vector<PageTriangle> at_rim;
  for (const PatchRange& range : drawn)
    for (const PageTriangle& triangle : triangles_of(mesh, range))
      if (is_rim[triangle[0]] + is_rim[triangle[1]] + is_rim[triangle[2]] > 0)
        at_rim.push_back(triangle);
  return at_rim;
}

std::vector<Vec3f> sum_rim_normals(std::span<const Vec3f> positions,
                                   std::span<const PageTriangle> at_rim, const PageRim& rim) {
  const std::vector<Vec3f> of_all = sum_corner_normals(positions, at_rim);
  std::vector<Vec3f> sums;
  sums.reserve(rim.size());
  for (const uint16_t vertex : rim) sums.push_back(of_all[vertex]);
  return sums;
}

namespace {

/// Numbers different points from 0 on, in the order in which they come.
class PointNumbers {
 public:
  explicit PointNumbers(size_t points_max)
      : slots_(std::bit_ceil(2 * points_max + 1), kFree), points_(slots_.size()) {}

  uint32_t number_of(const Vec3f& point) {
    size_t at = hash(point) & (slots_.size() - 1);
    while (slots_[at] != kFree && points_[at] != point) at = (at + 1) & (slots_.size() - 1);
    if (slots_[at] == kFree) {
      slots_[at] = count_++;
      points_[at] = point;
    }
    return slots_[at];
  }
  uint32_t count() const { return count_; }

 private:
  static constexpr uint32_t kFree = 0xffffffff;

  static size_t hash(const Vec3f& point) {
    uint64_t state = 0;
    for (const float part : point) {
      state = (state ^ std::bit_cast<uint32_t>(part)) * 0x9e3779b97f4a7c15u;
      state ^= state >> 32;
    }
    return state;
  }

  std::vector<uint32_t> slots_;
  std::vector<Vec3f> points_;
  uint32_t count_ = 0;
};

}  // namespace

Groups<RimPlace> group_rims(std::span<const RimmedPage> pages) {
  size_t vertices = 0;
  for (const RimmedPage& page : pages) vertices += page.rim->size();
  PointNumbers points(vertices);
  std::vector<uint32_t> numbers;  // per rim vertex, page by page
  numbers.reserve(vertices);
  for (const auto& [mesh, rim] : pages)
    for (const uint16_t vertex : *rim) numbers.push_back(points.number_of(mesh->positions[vertex]));
  return group_by<RimPlace>(points.count(), [&](const auto& add) {
    size_t next = 0;
    for (uint32_t page = 0; page < pages.size(); ++page)
      for (uint32_t i = 0; i < pages[page].rim->size(); ++i)
        add(numbers[next++], RimPlace{page, i});
  });
}

}  // namespace burnish
