#include "server/prepare/pages/cut_pages.h"

#include <algorithm>
#include <cmath>

#include "common/base/limits.h"
#include "server/prepare/pages/kd_cut.h"
#include "server/prepare/pages/triangle_runs.h"

namespace burnish {

namespace {

constexpr double kVerticesWanted = 0.96 * kPageVerticesMax;  // pages differ from their mean
constexpr double kTrianglesWanted = 3900;
constexpr size_t kPagesInAnyCase = 1024;                 // for dense parts: a minute to bake
constexpr size_t kPagesForDenseParts = 2;                // times the pages that are there without
constexpr std::array<double, 2> kRatios = {0.36, 0.64};  // of the cuts, in turn

KdRule rule_of(const LevelToCut& level, bool keeps_dense_parts) {
  KdRule rule;
  rule.triangles_wanted = static_cast<size_t>(
      std::min(kTrianglesWanted, kVerticesWanted / std::max(level.vertices_per_triangle, 0.01)));
  rule.ratio = kRatios[level.level % 2];
  rule.triangles = level.triangles;
  rule.texels = level.texels;
  rule.keeps_dense_parts = keeps_dense_parts;
  rule.positions = level.positions;
  return rule;
}

// Returns the places at which pages begin among the sorted centres.
std::vector<uint64_t> page_starts(std::span<const uint8_t> is_start) {
  std::vector<uint64_t> starts;
  for (size_t i = 0; i < is_start.size(); ++i)
    if (is_start[i]) starts.push_back(i);
  starts.push_back(is_start.size());
  return starts;
}

/// Orders the centres by page. Returns where pages begin among them.
std::vector<uint64_t> cut_runs(const LevelToCut& level, bool keeps_dense_parts, TriangleRuns& runs,
                               const ScratchSpace& space, const LoopPart& part) {
  ScratchArray<uint8_t> is_start(space, level.triangles.size());
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  const KdCut cut(rule_of(level, keeps_dense_parts), {runs.centres.data(), runs.centres.size()},
                  {is_start.data(), is_start.size()}, loop);
#pragma omp parallel
#pragma omp single
  for (size_t run = 0; run + 1 < runs.starts.size(); ++run)
    cut.split(runs.starts[run], runs.starts[run + 1]);
  leave_if_cancelled(loop);
  return page_starts({is_start.data(), is_start.size()});
}

}  // namespace

PageGroups cut_pages(const LevelToCut& level, const ScratchSpace& space, const LoopPart& part) {
  TriangleRuns runs = make_triangle_runs(level, space, part);
  PageGroups pages;
  pages.start = cut_runs(level, true, runs, space, part);
  // A scan whose density changes from triangle to triangle would have a page for each.
  if (level.texels.matter() && pages.count() > kPagesInAnyCase) {
    const size_t count = pages.count();
    pages.start = cut_runs(level, false, runs, space, part);
    if (count <= kPagesForDenseParts * pages.count())
      pages.start = cut_runs(level, true, runs, space, part);
  }
  pages.item = ScratchArray<uint32_t>(space, runs.centres.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < pages.item.size(); ++i) pages.item[i] = runs.centres[i].triangle;
  return pages;
}

}  // namespace burnish
