#pragma once

#include <cstdint>

namespace burnish {

/// Bytes of this process in physical memory now, and the most there were since its start or the
/// last reset; 0 where the system does not tell.
uint64_t resident_bytes();
uint64_t peak_resident_bytes();

/// Lets the peak start again from what is resident now, to measure a phase of work.
/// Returns false where the system does not permit it; then the peak goes on from the start.
bool reset_peak_resident_bytes();

}  // namespace burnish
