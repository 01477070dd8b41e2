#include "server/solver/cpu/smoothers/smoother.h"

namespace burnish::cpu {

std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, const HierarchyDepth& topology) {
  switch (kind) {
    case Smoother::kSchwarz:
      return make_schwarz(topology);
    case Smoother::kCellBlocks:
      return make_cell_blocks(topology);
    case Smoother::kChebyshevJacobi:
      return make_chebyshev_jacobi(topology);
    case Smoother::kGaussSeidel:
      return make_gauss_seidel(topology);
    case Smoother::kSlices:
      return make_slices(topology, {});
    case Smoother::kBlockedSlices:
      return make_slices(topology, {.temporal_blocking = true});
  }
  BURNISH_CHECK(false, "unknown smoother");
}

}  // namespace burnish::cpu
