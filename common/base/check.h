#pragma once

#include <string>

namespace burnish {

/// Prints the failed condition with its place and ends the process.
[[noreturn]] void check_failed(const char* condition, const char* file, int line,
                               const std::string& message);

}  // namespace burnish

/// Checks a contract between parts of this program. If it is broken, the program is wrong and must
/// stop. Errors of users or files are a Status instead.
#define BURNISH_CHECK(condition, message)                                 \
  do {                                                                    \
    if (!(condition)) [[unlikely]]                                        \
      ::burnish::check_failed(#condition, __FILE__, __LINE__, (message)); \
  } while (false)
