#include "client/model/local_server/private_server.h"

#include <cstdlib>
#include <unistd.h>

#include <gtest/gtest.h>

#include "client/model/local_server/user_socket.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

TEST(PrivateServer, ItsSocketIsInItsFolderHoweverThatIsSpelled) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "data");
  const fs::path socket = private_socket(folder / "data");
  EXPECT_EQ(socket, fs::canonical(folder / "data") / "window.sock");
  EXPECT_EQ(private_socket(folder / "data/"), socket);
  EXPECT_EQ(private_socket(folder / "data/../data/."), socket);
}

TEST(PrivateServer, OfALongPathTheSocketIsElsewhereAndOfThatFolderAlone) {
  const TemporaryFolder folder;
  const fs::path one = folder / std::string(100, 'x'), other = folder / std::string(101, 'x');
  setenv("XDG_RUNTIME_DIR", (folder / "run").c_str(), 1);
  EXPECT_EQ(private_socket(one).parent_path(), folder / "run/burnish");
  for (const std::string& runtime : {std::string(), std::string(100, '/')}) {
    setenv("XDG_RUNTIME_DIR", runtime.c_str(), 1);
    EXPECT_EQ(private_socket(one).parent_path(), "/tmp/burnish-" + std::to_string(geteuid()));
  }
  unsetenv("XDG_RUNTIME_DIR");
  EXPECT_LE(private_socket(one).native().size(), kSocketPathBytesMax);
  EXPECT_EQ(private_socket(one), private_socket(one));
  EXPECT_NE(private_socket(one), private_socket(other));
}

TEST(PrivateServer, WithoutAFolderOrAProgramItSaysSo) {
  EXPECT_EQ(find_private_server({}, {}).status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish
