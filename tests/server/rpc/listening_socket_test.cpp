#include "server/rpc/transport/listening_socket.h"

#include <cstring>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(ListeningSocket, Port0TakesAFreePort) {
  const auto first = ListeningSocket::tcp("127.0.0.1:0"), second = ListeningSocket::tcp("[::1]:0");
  ASSERT_TRUE(first.is_ok()) << first.status().message();
  EXPECT_GT(first.value().port(), 0);
  EXPECT_EQ(first.value().address(), "127.0.0.1:" + std::to_string(first.value().port()));
  if (!second.is_ok()) return;  // this machine has no IPv6
  EXPECT_THAT(second.value().address(), HasSubstr("[::1]:"));
}

TEST(ListeningSocket, APortInUseIsRefusedWithItsAddress) {
  const auto first = ListeningSocket::tcp("127.0.0.1:0");
  const auto second = ListeningSocket::tcp(first.value().address());
  EXPECT_EQ(second.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(second.status().message(),
              HasSubstr("cannot listen on " + first.value().address() + ": Address already in"));
}

TEST(ListeningSocket, AHostThatIsNoneIsRefused) {
  EXPECT_THAT(ListeningSocket::tcp("no host:1").status().message(), HasSubstr("no host:1"));
}

TEST(ListeningSocket, AUnixSocketIsForItsGroupAndGoesWithItsServer) {
  const TemporaryFolder folder;
  {
    const auto socket = ListeningSocket::unix_domain(folder / "s");
    ASSERT_TRUE(socket.is_ok()) << socket.status().message();
    EXPECT_EQ(fs::status(folder / "s").permissions(), fs::perms(0660));
    EXPECT_THAT(ListeningSocket::unix_domain(folder / "s").status().message(),
                HasSubstr("another server already listens"));
  }
  EXPECT_FALSE(fs::exists(folder / "s"));
}

TEST(ListeningSocket, AUnixSocketForItsUserAloneIsClosedToTheGroup) {
  const TemporaryFolder folder;
  const auto socket = ListeningSocket::unix_domain(folder / "s", SocketAccess::kUser);
  ASSERT_TRUE(socket.is_ok()) << socket.status().message();
  EXPECT_EQ(fs::status(folder / "s").permissions(), fs::perms(0600));
}

TEST(ListeningSocket, ASocketThatCannotBeAskedIsLeftAlone) {
  const TemporaryFolder folder;
  const std::string path = folder / "s";
  const int other = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);  // no stream connects to it
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
  ASSERT_EQ(bind(other, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_THAT(ListeningSocket::unix_domain(path).status().message(),
              HasSubstr("cannot tell whether the socket is in use"));
  EXPECT_TRUE(fs::exists(path));
  close(other);
}

TEST(ListeningSocket, AStaleUnixSocketIsReplacedAndAnyOtherFileIsNot) {
  const TemporaryFolder folder;
  const auto name = folder / "s", kept = folder / "kept";
  {
    const auto socket = ListeningSocket::unix_domain(name);
    fs::rename(name, kept);  // like a socket after a kill
  }
  fs::rename(kept, name);
  EXPECT_TRUE(ListeningSocket::unix_domain(name).is_ok());
  folder.write("file", "mine");
  EXPECT_THAT(ListeningSocket::unix_domain(folder / "file").status().message(),
              HasSubstr("not a socket"));
  EXPECT_EQ(content_of(folder / "file"), "mine");
}

}  // namespace
}  // namespace burnish
