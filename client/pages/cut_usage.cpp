#include "client/pages/cut_usage.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

static constexpr uint64_t kPageOverheadBytes = 1024;  // patches, the page's place in the cache

CutUsage& CutUsage::operator+=(const CutUsage& other) {
  triangles += other.triangles;
  vertices += other.vertices;
  resident_bytes += other.resident_bytes;
  slots += other.slots;
  return *this;
}

uint64_t resident_bytes_of(const PageEntry& entry, bool has_colours) {
  const uint64_t vertex_bytes = sizeof(Vec3i) + sizeof(Vec3f) + (has_colours ? sizeof(Rgba8) : 0);
  return kPageOverheadBytes + entry.bytes + entry.vertices * vertex_bytes +
         entry.triangles * sizeof(PageTriangle);
}

CutLimit exceeded_limit(const CutUsage& usage, const PageBudget& budget, double part) {
  const auto exceeds = [part](uint64_t used, uint64_t limit) {
    return static_cast<double>(used) > part * static_cast<double>(limit);
  };
  if (exceeds(usage.triangles, budget.triangles)) return CutLimit::kTriangles;
  if (exceeds(usage.vertices, budget.vertices)) return CutLimit::kVertices;
  if (exceeds(usage.resident_bytes, budget.resident_bytes)) return CutLimit::kMemory;
  if (exceeds(usage.slots, budget.slots())) return CutLimit::kCard;
  return CutLimit::kNone;
}

int coarseness_of(float excess) {
  const float steps = std::log(excess) / std::log(kCoarsenessBase);
  return static_cast<int>(std::clamp(steps, 0.0f, static_cast<float>(kCoarsenessMax)));
}

void UsageByCoarseness::clear() {
  std::ranges::fill(usage_, CutUsage{});
}

void UsageByCoarseness::add(int coarseness, const CutUsage& usage) {
  usage_[coarseness] += usage;
}

void UsageByCoarseness::sum() {
  for (int i = kCoarsenessMax; i >= 0; --i) usage_[i] += usage_[i + 1];
}

int UsageByCoarseness::least_that_fits(const PageBudget& budget, double part, int from) const {
  int coarseness = from;
  while (coarseness <= kCoarsenessMax &&
         exceeded_limit(at(coarseness), budget, part) != CutLimit::kNone)
    ++coarseness;
  return coarseness;
}

int next_coarseness(const UsageByCoarseness& usage, const PageBudget& budget, int last,
                    bool is_at_rest) {
  const int needed = usage.least_that_fits(budget, kBudgetAim, 0);
  if (needed >= last) return needed;
  if (is_at_rest) return last - 1;
  const bool has_room = exceeded_limit(usage.at(last), budget, kBudgetRefine) == CutLimit::kNone;
  return has_room ? last - 1 : last;
}

}  // namespace burnish
