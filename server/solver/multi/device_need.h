#pragma once

#include <cstdint>

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Returns the bytes of a device's memory that a scan and one session over it will take, with
/// edges kept. Works before either is there.
uint64_t predict_device_bytes(const Multigrid& on);

/// Returns on how many devices of `device_bytes` a scan of so many bytes fits. Each shard has some
/// cells at the cut besides its own.
int shards_that_fit(uint64_t bytes, uint64_t device_bytes);

}  // namespace burnish
