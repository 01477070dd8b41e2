#pragma once

#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/status.h"

namespace burnish {

/// Runs `work`, which returns a Status or a Result. Fails: resource_exhausted "`what`: not enough
/// memory" when an allocation in `work` fails.
template <typename Work>
auto with_memory_for(std::string_view what, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const std::bad_alloc&) {
    return resource_exhausted(std::string(what) + ": not enough memory");
  }
}

}  // namespace burnish
