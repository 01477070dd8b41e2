#pragma once

namespace burnish {

/// Makes the first device fail like a broken kernel: CUDA's error stays until the process ends.
void provoke_cuda_fault();

}  // namespace burnish
