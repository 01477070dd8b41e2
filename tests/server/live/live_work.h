#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/server/live/live_guest.h"
#include "tests/server/manager/test_library.h"

namespace burnish {

/// Ann's session "work" on a sphere; the test takes its turns.
class LiveWork : public testing::Test {
 protected:
  LiveWork();

  /// Returns a guest that shows nothing yet.
  LiveGuest guest(const std::string& user = "ann", const Greeting& wish = {"work"}) {
    return LiveGuest(*live_, *library_.store, wish, user);
  }

  /// Returns what the guest must show of a settled session: the displacement of its pages, rounded.
  std::vector<int32_t> sample(LiveGuest& guest);

  static Stroke stroke() { return {{0.4, 0.7, 0.2, FallOff::kSmooth}, {{1, 0, 0}, {0, 1, 0}}}; }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::unique_ptr<LiveSessions> live_;

 private:
  std::vector<Vec3f> displacement(const std::string& session);
};

}  // namespace burnish
