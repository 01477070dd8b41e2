#include "server/solver/cpu/products/transfer.h"

#include "common/base/blocks.h"
#include "server/solver/hierarchy/half_way.h"

namespace burnish::cpu {

void restrict_to_coarse(const CpuDepth& fine, const std::vector<Float4>& r, CpuDepth& coarse) {
  const DepthTransfer& transfer = fine.topology.to_parent;
#pragma omp parallel for schedule(dynamic, kBlock) if (coarse.corner_count() > kBlock)
  for (int32_t i = 0; i < coarse.corner_count(); ++i) {
    Float4 sum = Float4::Zero();
    for (int64_t k = transfer.restriction_start[i]; k < transfer.restriction_start[i + 1]; ++k)
      sum += transfer.restriction_weight[k] * r[transfer.restriction_corner[k]];
    coarse.f[i] = coarse.inverse_diagonal[i] > 0 ? sum : Float4(Float4::Zero());
  }
}

static constexpr int32_t kCornersAlone = 1024;  // for fewer, waking threads takes longer

static void add_prolonged(const DepthTransfer::SharedCorners& shared, const CpuDepth& coarse,
                          CpuDepth& fine) {
#pragma omp parallel for schedule(static) if (shared.count() > kCornersAlone)
  for (int32_t j = 0; j < shared.count(); ++j) {
    const int32_t i = shared.corner[j];
    if (fine.inverse_diagonal[i] == 0) continue;
    for (int32_t k = shared.start[j]; k < shared.start[j + 1]; ++k)
      fine.x[i] += shared.weight[k] * coarse.x[shared.coarse_corner[k]];
  }
}

void add_prolonged(const CpuDepth& coarse, CpuDepth& fine) {
  const auto& weights_of_place = half_way_weights();
  const DepthTransfer& transfer = fine.topology.to_parent;
#pragma omp parallel for schedule(dynamic, kBlock) if (fine.corner_count() > kBlock)
  for (int32_t i = 0; i < fine.corner_count(); ++i) {
    if (fine.inverse_diagonal[i] == 0) continue;
    if (transfer.is_shared(i)) continue;
    const FromCell from = transfer.prolongation[i];
    const auto& weights = weights_of_place[from.place];
    const auto& corners = coarse.topology.grid.cell_corners[from.cell];
    // Also adds zero weights: a processor cannot guess which weights are zero.
    Float4 sum = fine.x[i];
#pragma GCC unroll 8
    for (int a = 0; a < kCornersPerCell; ++a) sum += weights[a] * coarse.x[corners[a]];
    fine.x[i] = sum;
  }
  add_prolonged(transfer.shared, coarse, fine);
}

}  // namespace burnish::cpu
