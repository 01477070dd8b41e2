#include "tests/system/link.h"

#include <gtest/gtest.h>

#include "client/connection/session_link.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// A server with a sphere and a session over it.
class Links : public testing::Test {
 protected:
  Links() {
    Connection connection = Connection::open(server_.address, kPatience).value();
    EXPECT_TRUE(
        connection.import_scan(write_sphere(server_.folder, 6), "ball", {5, 0}, {}).is_ok());
    EXPECT_TRUE(connection.open_session({"ball", "work", {5, 0}}).is_ok());
  }

  ServerProcess server_;
};

TEST_F(Links, TakeAtLeastTheirDelayEachWay) {
  const Link link(server_.address, {.delay = milliseconds(30)});
  Connection connection = Connection::open(link.address(), kPatience).value();
  const auto begin = steady_clock::now();
  EXPECT_EQ(connection.list_scans()->size(), 1u);
  EXPECT_GE(steady_clock::now() - begin, milliseconds(60));
}

TEST_F(Links, PassAllBytesOnAndNoFasterThanTold) {
  const Link link(server_.address, {.megabits_per_second = 40, .delay = milliseconds(1)});
  Connection near = Connection::open(server_.address, kPatience).value();
  Connection far = Connection::open(link.address(), kPatience).value();
  const FetchedPages wanted = fetch_all_pages(near, "ball");
  const auto begin = steady_clock::now();
  const FetchedPages fetched = fetch_all_pages(far, "ball");
  // About 160,000 triangles of all levels, each of which takes more than a byte.
  EXPECT_GE(steady_clock::now() - begin, milliseconds(32));
  ASSERT_EQ(fetched.pages.size(), wanted.pages.size());
  for (size_t page = 0; page < wanted.pages.size(); ++page) {
    EXPECT_EQ(fetched.pages[page]->positions, wanted.pages[page]->positions);
    EXPECT_EQ(fetched.pages[page]->triangles, wanted.pages[page]->triangles);
  }
}

TEST_F(Links, CarryALiveSession) {
  const Link link(server_.address, {});
  Connection connection = Connection::open(link.address(), kPatience).value();
  SessionLink session(connection, fetch_all_pages(connection, "ball").live_options("work", 5));
  ASSERT_TRUE(session.apply({Edit{"a", SetGradientScale{0.5}}}).is_ok());
  EXPECT_TRUE(session.wait_until_acknowledged(kPatience));
  EXPECT_EQ(session.take().link, LinkState::kLive);
}

}  // namespace
}  // namespace burnish
