#include "common/page_frames/page_sample.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/base/parallel.h"
#include "common/evaluation/displacement_steps.h"
#include "common/page_frames/page_frame_header.h"

namespace burnish {

namespace {

// Returns the first value that is not finite, or the number of values.
uint32_t sample_page(const SparseGrid& grid, const PageEvaluation& evaluation,
                     std::span<const Vec3f> corner_displacements, float scale, PageSample& sample) {
  const auto size = static_cast<uint32_t>(evaluation.points.size());
  sample.page = evaluation.shown.page;
  sample.steps.resize(size_t{3} * size);
  for (uint32_t i = 0; i < size; ++i) {
    const Vec3f u = scale * evaluate(grid, evaluation.points[i], corner_displacements);
    if (!std::isfinite(u.x() + u.y() + u.z())) return i;
    for (int axis = 0; axis < 3; ++axis)
      sample.steps[size_t{static_cast<uint32_t>(axis)} * size + i] = to_steps(u[axis]);
  }
  return size;
}

}  // namespace

Result<std::vector<PageSample>> sample_pages(
    const SparseGrid& grid, std::span<const std::shared_ptr<const PageEvaluation>> pages,
    std::span<const Vec3f> corner_displacements, float scale) {
  BURNISH_CHECK(corner_displacements.size() == grid.corners.size(), "one displacement per corner");
  std::vector<PageSample> samples(pages.size());
  std::vector<uint32_t> finite(pages.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < pages.size(); ++i)
    failure.run(
        [&] { finite[i] = sample_page(grid, *pages[i], corner_displacements, scale, samples[i]); });
  failure.rethrow();
  for (size_t i = 0; i < pages.size(); ++i)
    if (finite[i] < pages[i]->points.size())
      return internal_error("displacement of value " + std::to_string(finite[i]) + " of page " +
                            std::to_string(pages[i]->shown.page) + " is not finite");
  return samples;
}

float largest_move(const SparseGrid& grid, std::span<const EvaluationPoint> points,
                   std::span<const Vec3f> corner_displacements, size_t stride,
                   std::span<const uint32_t> held) {
  float largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest)
  for (size_t i = 0; i < points.size(); i += stride) {
    const float length = evaluate(grid, points[i], corner_displacements).squaredNorm();
    if (length > largest && !std::ranges::binary_search(held, i)) largest = length;
  }
  return std::sqrt(largest);
}

uint8_t gain_exponent(double beta_max) {
  uint8_t exponent = 0;
  while (exponent < kPageGainExponentMax && std::ldexp(1.0, exponent) < beta_max) ++exponent;
  return exponent;
}

}  // namespace burnish
