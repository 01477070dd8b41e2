#include "common/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace burnish {

void check_failed(const char* condition, const char* file, int line, const std::string& message) {
  std::fprintf(stderr, "%s:%d: CHECK failed: %s: %s\n", file, line, condition, message.c_str());
  std::abort();
}

}  // namespace burnish
