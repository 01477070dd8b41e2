#pragma once

#include <string>

namespace burnish::bench {

/// Sets how many threads OpenMP and the BLAS behind CHOLMOD use from now on. One thread also ends
/// parallel loops that ask for their own number, like CHOLMOD's.
void use_threads_everywhere(int threads);

/// Returns "OpenBLAS 0.3.21 ..., 2 threads", or that the BLAS is another one, of one thread as far
/// as known.
std::string blas_in_words();

}  // namespace burnish::bench
