#include "common/frame_codec/frame_sample.h"

#include <cmath>

#include "common/evaluation/displacement_steps.h"

namespace burnish {

namespace {

template <typename Displacement>
Displacement value_at(const FrameLayout& layout, const FrameMesh& mesh,
                      std::span<const Displacement> corner_displacements, int value) {
  const int32_t source = layout.source[value];
  if (layout.content == FrameContent::kCoefficients) return corner_displacements[source];
  return evaluate(mesh.grid, mesh.points[source], corner_displacements);
}

Status not_finite(const FrameLayout& layout, int value) {
  const char* what = layout.content == FrameContent::kCoefficients ? "corner " : "vertex ";
  return internal_error("displacement of " + (what + std::to_string(layout.source[value])) +
                        " is not finite");
}

}  // namespace

template <typename Displacement>
Result<FrameSample> sample_displacement(const FrameLayout& layout, const FrameMesh& mesh,
                                        std::span<const Displacement> corner_displacements) {
  BURNISH_CHECK(corner_displacements.size() == mesh.grid.corners.size(),
                "one displacement per corner");
  FrameSample sample;
  sample.steps.resize(size_t{3} * layout.value_count());
  int first_bad = layout.value_count();
#pragma omp parallel for schedule(static) reduction(min : first_bad)
  for (int tile = 0; tile < layout.tile_count(); ++tile) {
    const int begin = layout.tile_begin(tile), size = layout.tile_size(tile);
    int32_t* steps = sample.steps.data() + size_t{3} * begin;
    for (int i = 0; i < size; ++i) {
      const Displacement u = value_at(layout, mesh, corner_displacements, begin + i);
      if (!std::isfinite(u.x() + u.y() + u.z())) {
        first_bad = std::min(first_bad, begin + i);
        continue;
      }
      for (int axis = 0; axis < 3; ++axis) steps[axis * size + i] = to_steps(u[axis]);
    }
  }
  if (first_bad < layout.value_count()) return not_finite(layout, first_bad);
  return sample;
}

template Result<FrameSample> sample_displacement(const FrameLayout&, const FrameMesh&,
                                                 std::span<const Vec3d>);
template Result<FrameSample> sample_displacement(const FrameLayout&, const FrameMesh&,
                                                 std::span<const Vec3f>);

}  // namespace burnish
