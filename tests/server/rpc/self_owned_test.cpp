#include "server/rpc/reactor/self_owned.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

class OwnedCall : public SelfOwned<OwnedCall> {
 public:
  explicit OwnedCall(bool& is_alive) : is_alive_(is_alive) { is_alive_ = true; }
  ~OwnedCall() { is_alive_ = false; }

  void begin() {}
  void end() { release(); }
  std::shared_ptr<OwnedCall> work() { return self(); }

 private:
  bool& is_alive_;
};

TEST(SelfOwned, ACallWithoutWorkGoesWithItsEnd) {
  bool is_alive = false;
  OwnedCall* call = OwnedCall::start(is_alive);
  EXPECT_TRUE(is_alive);
  call->end();
  EXPECT_FALSE(is_alive);
}

TEST(SelfOwned, WorkUnderWayMayAskForMoreAfterTheCallsEnd) {
  bool is_alive = false;
  OwnedCall* call = OwnedCall::start(is_alive);
  std::shared_ptr<OwnedCall> work = call->work();
  call->end();
  EXPECT_TRUE(is_alive);
  EXPECT_EQ(call->work(), work);
  work.reset();
  EXPECT_FALSE(is_alive);
}

}  // namespace
}  // namespace burnish
