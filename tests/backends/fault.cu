#include "tests/backends/fault.h"

namespace burnish {

static __global__ void trap_kernel() {
  __trap();
}

void provoke_cuda_fault() {
  cudaSetDevice(0);
  trap_kernel<<<1, 1>>>();
}

}  // namespace burnish
