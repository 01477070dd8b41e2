// Takes the place of server/solver/cuda in a build without CUDA.

#include "server/solver/cuda/cuda_backend.h"
#include "server/solver/cuda/cuda_filter.h"

namespace burnish {

static Status not_in_this_build() {
  return failed_precondition("this build has no CUDA backend (BURNISH_CUDA is off)");
}

bool cuda_compiled() {
  return false;
}

Result<std::string> cuda_device() {
  return not_in_this_build();
}

void set_cuda_memory_budget(uint64_t) {}

uint64_t cuda_memory_max() {
  return 0;
}

uint64_t cuda_memory_used() {
  return 0;
}

std::vector<uint64_t> cuda_memory_by_device() {
  return {0};
}

Status probe_cuda_device() {
  return not_in_this_build();
}

Result<std::unique_ptr<Backend>> make_cuda_backend(Multigrid, Smoother) {
  return not_in_this_build();
}

Result<CudaShards> make_cuda_shards(const CudaShardGroup&, std::span<CudaShard>) {
  return not_in_this_build();
}

Result<std::unique_ptr<SurfaceFilter>> make_cuda_filter(std::shared_ptr<const DenoiseSurface>) {
  return not_in_this_build();
}

}  // namespace burnish
