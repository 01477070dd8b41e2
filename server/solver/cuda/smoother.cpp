#include "server/solver/cuda/smoother.h"

#include "server/solver/cuda/gauss_seidel.h"
#include "server/solver/cuda/schwarz.h"

namespace burnish::cuda {

std::unique_ptr<DepthSmoother> make_smoother(Smoother kind, Stream& stream,
                                             const HierarchyDepth& topology, const Depth& depth) {
  if (kind == Smoother::kGaussSeidel) return std::make_unique<GaussSeidel>(stream, topology, depth);
  return std::make_unique<Schwarz>(stream, depth);
}

}  // namespace burnish::cuda
