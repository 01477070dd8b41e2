#include "client/connection/channel.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Channel, ASocketsPathMayHaveAnyLetters) {
  EXPECT_EQ(grpc_target("unix:/home/ada/.local/share/burnish/window.sock"),
            "unix:/home/ada/.local/share/burnish/window.sock");
  EXPECT_EQ(grpc_target("unix:/Köpfe 50%?#"), "unix:/K%C3%B6pfe%2050%25%3F%23");
}

TEST(Channel, AHostIsLeftAsItIs) {
  for (const char* server : {"127.0.0.1:7411", "[::1]:1", "dns:///host%20:1"})
    EXPECT_EQ(grpc_target(server), server);
}

}  // namespace
}  // namespace burnish
