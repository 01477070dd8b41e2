#include "client/live/server_route.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ServerRoute, FollowsTheSession) {
  ServerRoute route("one:7411");
  EXPECT_EQ(route.address(), "one:7411");
  route.move_to({"two:7411", "two"});
  EXPECT_EQ(route.place(), (ServerPlace{"two:7411", "two"}));
}

TEST(ServerRoute, BehindAProxyOnlyTheNameChanges) {
  ServerRoute route("edge:443");
  route.move_to({"", "two"});
  EXPECT_EQ(route.place(), (ServerPlace{"edge:443", "two"}));
  route.give_up("edge:443");
  EXPECT_EQ(route.place(), (ServerPlace{"edge:443", ""})) << "the proxy chooses among the others";
}

TEST(ServerRoute, WithoutAFleetItStaysAtAServerThatDoesNotAnswer) {
  ServerRoute route("one:7411");
  route.give_up("one:7411");
  EXPECT_EQ(route.address(), "one:7411");
}

TEST(ServerRoute, GoesRoundTheFleet) {
  ServerRoute route("two:7411");
  route.learn({"one:7411", "two:7411", "three:7411"});
  route.give_up("two:7411");
  EXPECT_EQ(route.address(), "three:7411");
  route.give_up("three:7411");
  EXPECT_EQ(route.address(), "one:7411");
}

TEST(ServerRoute, FromANameOfItsOwnItGoesToTheFirst) {
  ServerRoute route("edge:443");
  route.learn({"one:7411", "two:7411"});
  route.give_up("edge:443");
  EXPECT_EQ(route.address(), "one:7411");
}

TEST(ServerRoute, AServerThatSomebodyElseGaveUpIsGivenUpOnce) {
  ServerRoute route("one:7411");
  route.learn({"one:7411", "two:7411", "three:7411"});
  route.give_up("one:7411");
  route.give_up("one:7411");
  EXPECT_EQ(route.address(), "two:7411");
}

}  // namespace
}  // namespace burnish
