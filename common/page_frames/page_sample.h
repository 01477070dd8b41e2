#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/page_frames/page_evaluation.h"

namespace burnish {

/// The displacement of one page's values, rounded to 1/256 cell, ready for the encoders of all
/// clients that show the page.
struct PageSample {
  PageId page = 0;
  std::vector<int32_t> steps;  ///< all x, then all y, then all z
};

/// Samples a displacement once for all pages that any client shows, `scale` times as large. A
/// vertex of several pages gets the same value in each. Runs in parallel over pages. Shapes: one
/// displacement per corner of the grid; one sample per page. Units: cells. Fails: internal, naming
/// the first page and value whose displacement is not finite.
Result<std::vector<PageSample>> sample_pages(
    const SparseGrid& grid, std::span<const std::shared_ptr<const PageEvaluation>> pages,
    std::span<const Vec3f> corner_displacements, float scale = 1);

/// Returns the length of the largest displacement of the points, in cells. Give it all points of
/// the scan: corners alone would not do, since those that hardly weigh on a vertex wander. Looks at
/// every `stride`-th point. Leaves out those that are `held`, rising. Needs: stride >= 1.
float largest_move(const SparseGrid& grid, std::span<const EvaluationPoint> points,
                   std::span<const Vec3f> corner_displacements, size_t stride = 1,
                   std::span<const uint32_t> held = {});

/// Returns the least e <= kPageGainExponentMax with 2^e >= beta; 0 for a beta up to 1.
uint8_t gain_exponent(double beta_max);

}  // namespace burnish
