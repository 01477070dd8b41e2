#include "tests/system/link.h"

#include <gtest/gtest.h>

#include "client/connection/session_link.h"
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
  const View wanted = near.fetch_view({"ball", {5, 0}}, {}).value();
  const auto begin = steady_clock::now();
  const View view = far.fetch_view({"ball", {5, 0}}, {}).value();
  // About 40,000 vertices, each of which takes more than five bytes.
  EXPECT_GE(steady_clock::now() - begin, milliseconds(40));
  EXPECT_EQ(view.triangles, wanted.triangles);
  EXPECT_EQ(view.vertices, wanted.vertices);
}

TEST_F(Links, CarryALiveSession) {
  const Link link(server_.address, {});
  Connection connection = Connection::open(link.address(), kPatience).value();
  LiveOptions options;
  options.greeting.session = "work";
  options.view = std::make_shared<const View>(connection.fetch_view({"ball", {5, 0}}, {}).value());
  SessionLink session(connection, options);
  ASSERT_TRUE(session.apply({Edit{"a", SetGradientScale{0.5}}}).is_ok());
  EXPECT_TRUE(session.wait_until_acknowledged(kPatience));
  EXPECT_EQ(session.take().link, LinkState::kLive);
}

}  // namespace
}  // namespace burnish
