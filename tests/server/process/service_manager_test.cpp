#include "server/process/service_manager.h"

#include <cstdlib>
#include <cstring>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

TEST(ServiceManager, HearsWhatItIsTold) {
  const TemporaryFolder folder;
  const std::string path = (folder / "notify").string();
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
  const int fd = socket(AF_UNIX, SOCK_DGRAM, 0);
  ASSERT_EQ(bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  setenv("NOTIFY_SOCKET", path.c_str(), 1);
  notify_service_manager("READY=1");
  unsetenv("NOTIFY_SOCKET");
  char text[64] = {};
  EXPECT_EQ(recv(fd, text, sizeof(text) - 1, MSG_DONTWAIT), 7);
  EXPECT_STREQ(text, "READY=1");
  close(fd);
}

TEST(ServiceManager, WithoutOneNothingIsSaid) {
  unsetenv("NOTIFY_SOCKET");
  notify_service_manager("READY=1");
  unsetenv("WATCHDOG_USEC");
  EXPECT_EQ(watchdog_interval().count(), 0);
  setenv("WATCHDOG_USEC", "3000000", 1);
  EXPECT_EQ(watchdog_interval(), std::chrono::milliseconds(1500));
  unsetenv("WATCHDOG_USEC");
}

}  // namespace
}  // namespace burnish
