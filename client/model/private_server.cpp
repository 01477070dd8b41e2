#include "client/model/private_server.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <thread>
#include <unistd.h>
#include <vector>

#include <sys/wait.h>

#include "common/base/atomic_file.h"

namespace burnish {

static constexpr auto kPoll = std::chrono::milliseconds(20);

static std::filesystem::path server_program() {
  std::error_code error;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", error);
  return here.parent_path() / "burnish-server";
}

static std::string last_line(const std::filesystem::path& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

// 0 where there is none.
static int read_port(const std::filesystem::path& file) {
  int port = 0;
  std::ifstream(file) >> port;
  return port;
}

static std::string loopback(int port) {
  return "127.0.0.1:" + std::to_string(port);
}

// It outlives this program only when that is killed; its edits are on disk, and it can be asked to
// end by its number in the log.
static pid_t spawn(const std::vector<std::string>& words, const std::filesystem::path& log) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string log_name = log.string();
  const pid_t pid = fork();
  if (pid != 0) return pid;
  const int output = open(log_name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  setpgid(0, 0);  // Ctrl+C at a terminal is for the window, which then ends us in order
  execv(arguments[0], arguments.data());
  _exit(127);
}

Result<std::unique_ptr<PrivateServer>> PrivateServer::start(const std::filesystem::path& data,
                                                            const Progress& progress) {
  if (data.empty()) return not_found("there is no home folder for a private server's scans");
  const std::filesystem::path program = server_program();
  if (access(program.c_str(), X_OK) != 0)
    return not_found("no " + program.string() + ": name a server with --server");
  std::error_code error;
  std::filesystem::create_directories(data, error);
  if (error) return errno_status("cannot make " + data.string(), error.value());
  const auto port_file = data / "window-port", log = data / "window-server.log";
  const int others_port = read_port(port_file);
  std::filesystem::remove(port_file, error);
  const pid_t pid = spawn({program.string(), "--listen", "127.0.0.1:0", "--data", data.string(),
                           "--port-file", port_file.string()},
                          log);
  if (pid < 0) return errno_status("cannot start " + program.string(), errno);
  auto server = std::unique_ptr<PrivateServer>(new PrivateServer(pid, ""));
  while (report(progress, "starting a private server", 0)) {
    if (const int port = read_port(port_file)) {
      server->address_ = loopback(port);
      return server;
    }
    if (waitpid(pid, nullptr, WNOHANG) == pid) {
      server->pid_ = 0;
      if (others_port == 0) return unavailable("the private server ended: " + last_line(log));
      // The folder is in use: by the server of another window, which serves this one as well.
      RETURN_IF_ERROR(write_file(port_file, std::to_string(others_port) + "\n"));
      server->address_ = loopback(others_port);
      return server;
    }
    std::this_thread::sleep_for(kPoll);
  }
  return cancelled("starting a private server was cancelled");
}

PrivateServer::~PrivateServer() {
  if (pid_ == 0) return;
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
}

}  // namespace burnish
