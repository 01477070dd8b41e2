#include "client/model/local_server/user_socket.h"

#include <csignal>
#include <cstring>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

int bound_socket(const std::filesystem::path& path) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, path.c_str());
  const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
  EXPECT_EQ(bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return fd;
}

TEST(UserSocket, TellsWhetherSomebodyListens) {
  const TemporaryFolder folder;
  const auto path = folder / "s";
  EXPECT_EQ(user_listens(path).value(), false);
  const int fd = bound_socket(path);
  EXPECT_EQ(user_listens(path).value(), false);
  ASSERT_EQ(listen(fd, 1), 0);
  EXPECT_EQ(user_listens(path).value(), true);
  close(fd);  // as after a crash: the file of the socket stays
  EXPECT_EQ(user_listens(path).value(), false);
}

TEST(UserSocket, APathThatDoesNotFitIsRefusedWithItsLength) {
  const auto listens = user_listens("/" + std::string(107, 'x'));
  EXPECT_THAT(listens.status().message(), AllOf(HasSubstr("108 bytes"), HasSubstr("107")));
}

TEST(UserSocket, AServerOfAnotherUserIsRefused) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
  const TemporaryFolder folder;
  const int fd = bound_socket(folder / "s");
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  const pid_t impostor = fork();
  if (impostor == 0) {  // the client sees the process that calls listen()
    const bool listens = setuid(65534) == 0 && listen(fd, 1) == 0;
    (void)!write(pipe[1], listens ? "y" : "n", 1);
    pause();
  }
  char answer = 0;
  EXPECT_EQ(read(pipe[0], &answer, 1), 1);
  EXPECT_EQ(answer, 'y');
  const auto listens = user_listens(folder / "s");
  EXPECT_EQ(listens.status().code(), StatusCode::kPermissionDenied);
  EXPECT_THAT(listens.status().message(), HasSubstr("belongs to user 65534, not to 0"));
  kill(impostor, SIGKILL);
  waitpid(impostor, nullptr, 0);
}

}  // namespace
}  // namespace burnish
