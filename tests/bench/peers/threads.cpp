#include "tests/bench/peers/threads.h"

#include <dlfcn.h>

#include "common/base/parallel.h"

namespace burnish::bench {

// The machine chooses the program's BLAS: Debian's administrator sets it.
template <typename Function>
static Function* find_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

void use_threads_everywhere(int threads) {
  use_threads(threads);
#ifdef _OPENMP
  omp_set_max_active_levels(threads > 1 ? 1 : 0);
#endif
  if (auto* set_blas_threads = find_function<void(int)>("openblas_set_num_threads"))
    set_blas_threads(threads);
}

std::string blas_in_words() {
  auto* config = find_function<char*()>("openblas_get_config");
  auto* blas_threads = find_function<int()>("openblas_get_num_threads");
  if (config == nullptr || blas_threads == nullptr)
    return "not OpenBLAS (Debian's libopenblas0-pthread): one thread and slow";
  return std::string(config()) + ", " + std::to_string(blas_threads()) + " threads";
}

}  // namespace burnish::bench
