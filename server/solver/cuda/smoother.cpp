#include "server/solver/cuda/smoother.h"

#include "server/solver/cuda/gauss_seidel.h"
#include "server/solver/cuda/schwarz.h"
#include "server/solver/hierarchy.h"

namespace burnish::cuda {

std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, Stream& stream,
                                             const HierarchyDepth& topology, const Depth& depth) {
  if (kind == Smoother::kGaussSeidel) return std::make_unique<GaussSeidel>(stream, topology, depth);
  const bool is_finest = topology.child_start.empty();
  return std::make_unique<Schwarz>(stream, depth, is_finest && topology.has_weak_parts);
}

}  // namespace burnish::cuda
