// The private server that windows on one computer share (USERS B3, B4; ATTACKS C4).

#include "client/model/local_server/private_server.h"

#include <csignal>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <future>
#include <grp.h>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>

#include "client/connection/connection.h"
#include "client/scene/null_page_renderer.h"
#include "tests/system/private_data.h"
#include "tests/system/workspace_pictures.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::perms mode_of(const fs::path& path) {
  return fs::status(path).permissions();
}

template <typename What>
bool eventually(What what) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!what()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

bool has_ended(pid_t pid) {
  return kill(pid, 0) != 0;
}

/// Returns the inodes of sockets in a table of /proc/net.
std::string socket_table(const char* name) {
  return content_of(fs::path("/proc/net") / name);
}

/// Returns how many TCP sockets a process listens on or is connected by.
size_t tcp_sockets(pid_t pid) {
  const std::string table = socket_table("tcp") + socket_table("tcp6");
  size_t count = 0;
  for (const auto& entry : fs::directory_iterator("/proc/" + std::to_string(pid) + "/fd")) {
    std::error_code gone;
    const std::string target = fs::read_symlink(entry, gone).string();
    if (!target.starts_with("socket:[")) continue;
    count += table.find(" " + target.substr(8, target.size() - 9) + " ") != std::string::npos;
  }
  return count;
}

/// Tries what another user could try. Returns what worked.
std::string as_nobody(const PrivateData& data) {
  const std::string folder = data.options.data, socket_path = private_socket(data.options.data);
  const std::string journal = folder + "/journal.sqlite", lock = folder + "/lock";
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, socket_path.c_str());
  int pipe[2];
  EXPECT_EQ(::pipe(pipe), 0);
  const pid_t nobody = fork();
  if (nobody == 0) {  // only system calls: other threads may have held locks
    const auto tell = [&](const char* what) { (void)!write(pipe[1], what, std::strlen(what)); };
    if (setgroups(0, nullptr) != 0 || setgid(65534) != 0 || setuid(65534) != 0) tell("setuid ");
    struct stat found;
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    if (connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) tell("connect ");
    if (stat(socket_path.c_str(), &found) == 0) tell("stat ");
    if (open(folder.c_str(), O_RDONLY | O_DIRECTORY) >= 0) tell("list ");
    if (open(journal.c_str(), O_RDONLY) >= 0) tell("read ");
    if (open(lock.c_str(), O_RDONLY) >= 0) tell("lock ");
    if (open((folder + "/mine").c_str(), O_WRONLY | O_CREAT, 0600) >= 0) tell("write ");
    _exit(0);
  }
  close(pipe[1]);
  waitpid(nobody, nullptr, 0);
  char worked[200] = {};
  EXPECT_GE(read(pipe[0], worked, sizeof worked - 1), 0);
  close(pipe[0]);
  return worked;
}

TEST(PrivateServer, ListensOnASocketAloneAndKeepsAllForItsUser) {
  const PrivateData data;
  data.folder.write("before", "");
  fs::create_directory(data.options.data);
  fs::permissions(data.options.data, fs::perms(0755));  // as older versions left it
  std::ofstream(data.options.data / "window-port") << "4711\n";
  const auto address = find_private_server(data.options, {});
  ASSERT_TRUE(address.is_ok()) << address.status().message();
  EXPECT_EQ(*address, "unix:" + (data.options.data / "window.sock").string());
  EXPECT_EQ(tcp_sockets(data.server()), 0u);
  EXPECT_EQ(mode_of(data.options.data), fs::perms(0700));
  EXPECT_FALSE(fs::exists(data.options.data / "window-port"));
  auto connection = Connection::open(*address, kPatience);
  ASSERT_TRUE(connection.is_ok()) << connection.status().message();
  ASSERT_TRUE(connection->import_scan(write_sphere(data.folder), "ball", {5, 0}, {}).is_ok());
  for (const auto& entry : fs::recursive_directory_iterator(data.options.data))
    EXPECT_EQ(mode_of(entry) & fs::perms(0077), fs::perms::none) << entry.path();
}

TEST(PrivateServer, NobodyElseCanReachItOrItsFiles) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
  const PrivateData data;
  ASSERT_TRUE(find_private_server(data.options, {}).is_ok());
  EXPECT_EQ(as_nobody(data), "");
  data.kill_server();  // no server may take its place either
  EXPECT_EQ(as_nobody(data), "");
}

TEST(PrivateServer, WindowsThatStartAtOnceShareOne) {
  const PrivateData data;
  std::vector<std::future<Status>> windows;
  for (int i = 0; i < 8; ++i)
    windows.push_back(std::async(std::launch::async,
                                 [&] { return find_private_server(data.options, {}).status(); }));
  for (auto& window : windows) {
    const Status found = window.get();
    EXPECT_TRUE(found.is_ok()) << found.message();
  }
  const pid_t server = data.server();
  EXPECT_TRUE(find_private_server(data.options, {}).is_ok());
  EXPECT_EQ(data.server(), server);
}

TEST(PrivateServer, EndsByItselfOnceNobodyIsConnectedAndIsStartedAgain) {
  PrivateData data;
  data.options.idle_exit = std::chrono::seconds(1);  // by the clock of another process
  const std::string address = find_private_server(data.options, {}).value();
  const pid_t first = data.server();
  { const auto connection = Connection::open(address, kPatience); }
  EXPECT_TRUE(eventually([&] { return has_ended(first); }));
  EXPECT_THAT(content_of(data.options.data / "window-server.log"), HasSubstr("unused for 1 s"));
  ASSERT_TRUE(find_private_server(data.options, {}).is_ok());
  EXPECT_NE(data.server(), first);
  EXPECT_THAT(content_of(data.options.data / "window-server.old.log"), HasSubstr("unused for 1 s"));
}

TEST(PrivateServer, WhyItEndsIsSaid) {
  const PrivateData data;
  fs::create_directories(data.options.data / "journal.sqlite");  // a folder, not a file
  const auto found = find_private_server(data.options, {});
  EXPECT_EQ(found.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(found.status().message(), HasSubstr("the private server ended: burnish-server: "));
}

TEST(PrivateServer, WorksWhereThePathIsTooLongForASocketOrHasOddLetters) {
  for (const std::string& name : {std::string(200, 'x'), std::string("Köpfe 50 % fertig?#")}) {
    PrivateData data;
    data.options.data = data.folder / name;
    setenv("XDG_RUNTIME_DIR", (data.folder / "run").c_str(), 1);
    const auto address = find_private_server(data.options, {});
    ASSERT_TRUE(address.is_ok()) << address.status().message();
    EXPECT_TRUE(Connection::open(*address, kPatience).is_ok()) << name;
    EXPECT_EQ(mode_of(private_socket(data.options.data).parent_path()), fs::perms(0700));
    data.kill_server();
    unsetenv("XDG_RUNTIME_DIR");
  }
}

TEST(PrivateServer, CanBeCancelledWhileItStarts) {
  const PrivateData data;
  const auto found = find_private_server(data.options, [](auto, double) { return false; });
  EXPECT_EQ(found.status().code(), StatusCode::kCancelled);
}

/// A Workspace without a window, on its user's private server.
class PrivateWorkspace : public testing::Test {
 protected:
  PrivateWorkspace() { workspace_.viewport.set_size({400, 300}); }

  template <typename What>
  bool until(What what) {
    return pictures_until(workspace_, what);
  }
  bool until_connected() {
    return until([this] { return workspace_.library().state == Library::State::kConnected; });
  }
  void open_ball() {
    workspace_.connect_privately();
    ASSERT_TRUE(until_connected());
    workspace_.import_scan(write_sphere(data_.folder));
    ASSERT_TRUE(until([this] { return workspace_.document() && document().is_settled(); }));
  }
  Document& document() { return *workspace_.document(); }
  std::string errors() const {
    std::string errors;
    for (const Message& message : workspace_.log.messages())
      if (message.severity == Severity::kError) errors += message.text + "\n";
    return errors;
  }

  PrivateData data_;
  NullPageRenderer renderer_;
  Workspace workspace_{renderer_, Preferences(), WorkspaceOptions{.private_server = data_.options}};
};

TEST_F(PrivateWorkspace, StartsItsServerAgainAndBringsWhatWasEditedMeanwhile) {
  open_ball();
  const pid_t first = data_.server();
  data_.kill_server();
  document().preview_beta(0.25);
  document().commit_beta();
  EXPECT_EQ(workspace_.unsaved().edits, 1u);
  ASSERT_TRUE(until([this] {
    return document().is_settled() && document().stats().frame.edits == 1 &&
           document().history().size() == 1;
  }));
  EXPECT_NE(data_.server(), first);
  EXPECT_EQ(workspace_.unsaved().edits, 0u);
  EXPECT_EQ(errors(), "");
}

TEST_F(PrivateWorkspace, UseThisComputerWorksAfterACrash) {
  workspace_.connect_privately();
  ASSERT_TRUE(until_connected());
  data_.kill_server();
  workspace_.connect_privately();
  ASSERT_TRUE(until_connected());
  EXPECT_EQ(errors(), "");
}

TEST_F(PrivateWorkspace, AScanIsImportedThoughTheServerHasJustDied) {
  workspace_.connect_privately();
  ASSERT_TRUE(until_connected());
  ASSERT_TRUE(until([this] { return workspace_.is_idle(); }));
  data_.kill_server();
  workspace_.import_scan(write_sphere(data_.folder));
  ASSERT_TRUE(until([this] { return workspace_.document() && document().is_settled(); }))
      << errors();
  EXPECT_EQ(errors(), "");
}

TEST_F(PrivateWorkspace, ASessionThatIsLeftBeforeItsEditsAreSavedIsNamed) {
  open_ball();
  const std::string name = document().session().name;
  data_.kill_server();
  document().preview_beta(0.25);
  document().commit_beta();
  workspace_.close_document();
  EXPECT_EQ(workspace_.log.messages().back().text, name + ": 1 edit is not saved and will be lost");
}

}  // namespace
}  // namespace burnish
