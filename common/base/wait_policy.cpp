#include "common/base/wait_policy.h"

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace burnish {

void sleep_while_waiting([[maybe_unused]] char** argv) {
#ifdef _OPENMP
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error || setenv("OMP_WAIT_POLICY", "passive", 1) != 0) return;
  execv(program.c_str(), argv);  // if execv() returns, threads spin
#endif
}

}  // namespace burnish
