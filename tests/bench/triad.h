#pragma once

namespace burnish {

/// Returns the memory bandwidth of a[i] = b[i] + s·c[i] over arrays far larger than the caches,
/// GB/s, best of several. Every frame time is compared with it.
double triad_gigabytes_per_second();

}  // namespace burnish
