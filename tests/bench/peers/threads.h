#pragma once

#include <string>

namespace burnish::bench {

/// How many threads OpenMP and the BLAS behind CHOLMOD use from now on. One thread also ends the
/// parallel loops that ask for a number of their own, as CHOLMOD's do.
void use_threads_everywhere(int threads);

/// "OpenBLAS 0.3.21 ..., 2 threads", or that the BLAS is another one, of one thread as far as
/// known.
std::string blas_in_words();

}  // namespace burnish::bench
