#pragma once

#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/status.h"

namespace burnish {

/// Runs `work`, which returns a Status or a Result. Fails: resource_exhausted "`what`: not enough
/// memory" when an allocation in `work` fails. A program without exceptions ends instead.
template <typename Work>
auto with_memory_for([[maybe_unused]] std::string_view what, Work&& work) -> decltype(work()) {
#ifdef __cpp_exceptions
  try {
    return std::forward<Work>(work)();
  } catch (const std::bad_alloc&) {
    return resource_exhausted(std::string(what) + ": not enough memory");
  }
#else
  return std::forward<Work>(work)();
#endif
}

}  // namespace burnish
