#include "common/denoise/normal_filter.h"

#include <utility>

#include "common/denoise/filter_constants.h"
#include "common/denoise/heard_blocks.h"
#include "common/denoise/ring_nearness.h"
#include "common/denoise/ring_sums.h"

namespace burnish {

NormalFilter::NormalFilter(const WeldedSurface& surface, const TriangleRings& rings,
                           NormalFilterKind kind, double sigma, const ScratchSpace& space,
                           const LoopPart& part)
    : surface_(surface),
      rings_(rings),
      space_(space),
      is_guided_(kind == NormalFilterKind::kEdges),
      steepness_(steepness_of(sigma)),
      now_(triangle_normals(surface, space, part.of(0, 0.2))),
      next_(space, rings.size()),
      guides_(space, is_guided_ ? rings.size() : 0),
      measured_(space, guides_.size()),
      nearness_(ring_nearness(surface, rings, {now_.data(), now_.size()}, reach_of(kind), space,
                              part.of(0.2, 1))) {}

void NormalFilter::restart(double sigma, const LoopPart& part) {
  now_ = triangle_normals(surface_, space_, part);
  steepness_ = steepness_of(sigma);
}

void NormalFilter::make_guides(const LoopPart& part) {
  const RingField field = {rings_.starts(), rings_.triangles(), now_.data()};
  for_each_block_heard(part.of(0, 0.5), rings_.size(), [&](size_t begin, size_t end) {
    measure_rings(field, begin, end, measured_.data());
  });
  for_each_block_heard(part.of(0.5, 1), rings_.size(), [&](size_t begin, size_t end) {
    pick_rings(field, measured_.data(), kGuideSharpness, begin, end, guides_.data());
  });
}

void NormalFilter::pass(const LoopPart& part) {
  if (is_guided_) make_guides(part.of(0, 0.6));
  const RingField field = {rings_.starts(), rings_.triangles(), now_.data()};
  const Float4* guides = is_guided_ ? guides_.data() : now_.data();
  for_each_block_heard(
      part.of(is_guided_ ? 0.6 : 0, 1), rings_.size(), [&](size_t begin, size_t end) {
        sum_rings(field, nearness_.data(), guides, steepness_, begin, end, next_.data());
      });
  std::swap(now_, next_);
}

}  // namespace burnish
