#pragma once

/// Goes before a function. Compiles it once for each level of x86-64; the program takes the best
/// level of the machine when it starts. Such functions hold the hot loops, take plain pointers,
/// start no threads, and call only functions that the compiler inlines. Products and sums are never
/// contracted (deploy/cmake/targets.cmake), so that every level gives the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BURNISH_DISPATCH \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define BURNISH_DISPATCH
#endif

namespace burnish {

/// Registers of several numbers. The compiler splits them if the machine's registers are shorter.
using Float8 = float __attribute__((vector_size(32)));
using Double8 = double __attribute__((vector_size(64)));

}  // namespace burnish
