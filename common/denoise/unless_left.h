#pragma once

#include <new>
#include <string>

#include "common/base/heard_loop.h"
#include "common/base/status.h"

namespace burnish {

/// Returns the value that a work of denoising makes, or why it made none: cancelled,
/// resource_exhausted.
template <typename Work>
auto unless_left(const Work& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const WorkCancelled&) {
    return cancelled("denoising was cancelled");
  } catch (const std::bad_alloc& failure) {
    return resource_exhausted(std::string("denoising has no memory: ") + failure.what());
  }
}

}  // namespace burnish
