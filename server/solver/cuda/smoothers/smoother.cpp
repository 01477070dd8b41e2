#include "server/solver/cuda/smoothers/smoother.h"

#include "server/solver/cuda/smoothers/paper/gauss_seidel.h"
#include "server/solver/cuda/smoothers/schwarz.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {

std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, Stream& stream,
                                             const HierarchyDepth& topology, const Depth& depth,
                                             bool needs_all_digits, Halo* halo) {
  if (kind == Smoother::kGaussSeidel) return std::make_unique<GaussSeidel>(stream, topology, depth);
  return std::make_unique<Schwarz>(stream, depth, topology.is_finest() && needs_all_digits, halo,
                                   topology.grid.depth);
}

}  // namespace burnish::cuda
