#pragma once

#include <cstdint>

namespace burnish {

uint64_t resident_bytes();       ///< this process's resident memory now
uint64_t peak_resident_bytes();  ///< its largest since the start or the last reset
/// Starts the peak anew; false and without effect where the kernel does not allow it.
bool reset_peak_resident_bytes();
/// What the machine can still give without swapping.
uint64_t available_memory_bytes();

}  // namespace burnish
