#pragma once

namespace burnish {

/// Memory bandwidth of a[i] = b[i] + s·c[i] over arrays far larger than the caches, GB/s, best of
/// several: what every frame time is measured against.
double triad_gigabytes_per_second();

}  // namespace burnish
