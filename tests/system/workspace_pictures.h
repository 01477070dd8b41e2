#pragma once

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "client/model/workspace/workspace.h"
#include "tests/system/server_process.h"

namespace burnish {

/// Takes pictures of a Workspace without a window until `what()` holds. Returns false after the
/// patience.
template <typename What>
bool pictures_until(Workspace& workspace, What what) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    workspace.update();
    EXPECT_TRUE(workspace.look().is_ok());
    if (what()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace burnish
