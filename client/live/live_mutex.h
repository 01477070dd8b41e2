#pragma once

#ifndef __wasm__
#include <mutex>
#endif

namespace burnish {

#ifdef __wasm__
// A browser runs this code on one thread, and its standard library has no mutex.
struct LiveMutex {};
struct LiveGuard {
  explicit LiveGuard(LiveMutex&) {}
};
#else
using LiveMutex = std::mutex;
using LiveGuard = std::lock_guard<LiveMutex>;
#endif

}  // namespace burnish
