#pragma once

namespace burnish {

/// Makes the first device fail as a broken kernel does: CUDA's error sticks to the process.
void provoke_cuda_fault();

}  // namespace burnish
