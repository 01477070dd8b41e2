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

  LiveGuest guest(const std::string& user = "ann", const Greeting& wish = {"work"}) {
    return LiveGuest(*live_, wish, user);
  }

  /// Returns what the guest must show of a settled session: the displacement, rounded.
  FrameSample sample(LiveGuest& guest);

  /// Returns what the guest shows, in the sample's order.
  static FrameSample shown(LiveGuest& guest);

  static Stroke stroke() { return {{0.4, 0.7, 0.2, FallOff::kSmooth}, {{1, 0, 0}, {0, 1, 0}}}; }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::unique_ptr<LiveSessions> live_;

 private:
  std::vector<Vec3f> displacement();
};

}  // namespace burnish
