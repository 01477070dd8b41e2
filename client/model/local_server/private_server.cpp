#include "client/model/local_server/private_server.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <optional>
#include <thread>
#include <unistd.h>

#include <sys/file.h>

#include "client/model/files/private_folder.h"
#include "client/model/local_server/detached_program.h"
#include "client/model/local_server/user_socket.h"
#include "common/base/process_memory.h"

namespace burnish {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

static constexpr auto kPoll = std::chrono::milliseconds(20);
// A server that is ending may still finish calls.
static constexpr std::chrono::seconds kPatience{20};

static fs::path server_program() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path() / "burnish-server";
}

static std::string last_line(const fs::path& log) {
  std::ifstream file(log);
  std::string line, last;
  while (std::getline(file, line))
    if (!line.empty()) last = line;
  return last;
}

/// Returns the same path for all names of one folder.
static fs::path full_path(const fs::path& data) {
  std::error_code error;
  const fs::path full = fs::weakly_canonical(fs::absolute(data), error);
  return error ? fs::absolute(data).lexically_normal() : full;
}

// Hashes the path by FNV-1a, so that two folders with long paths have two sockets.
static std::string short_name(const fs::path& path) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : path.native()) hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001b3;
  return "window-" + std::to_string(hash) + ".sock";
}

static fs::path short_folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime && *runtime == '/') {
    fs::path folder = fs::path(runtime) / "burnish";
    if (folder.native().size() < kSocketPathBytesMax / 2) return folder;
  }
  return "/tmp/burnish-" + std::to_string(geteuid());
}

fs::path private_socket(const fs::path& data) {
  const fs::path full = full_path(data);
  fs::path inside = full / "window.sock";
  if (inside.native().size() <= kSocketPathBytesMax) return inside;
  return short_folder() / short_name(full);
}

/// A lock on a file by flock(). Makes a missing file; the destructor releases the lock.
class FileLock {
 public:
  explicit FileLock(const fs::path& path)
      : fd_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600)) {}
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock() {
    if (fd_ >= 0) close(fd_);
  }
  bool is_open() const { return fd_ >= 0; }
  bool try_take() const { return fd_ >= 0 && flock(fd_, LOCK_EX | LOCK_NB) == 0; }

 private:
  int fd_;
};

/// Returns true if a server has the folder. It may be starting, ending, or listening elsewhere.
static bool is_taken(const fs::path& data) {
  return !FileLock(data / "lock").try_take();
}

static Result<DetachedProgram> start_server(const PrivateServerOptions& options,
                                            const fs::path& data, const fs::path& socket) {
  std::error_code ignored;
  fs::remove(data / "window-port", ignored);  // left by older versions, which listened on a port
  const fs::path log = data / "window-server.log";
  fs::rename(log, data / "window-server.old.log", ignored);  // it may say why the last server ended
  return DetachedProgram::start(
      {server_program().string(), "--listen", "", "--socket", socket.string(), "--socket-user-only",
       "--data", data.string(), "--idle-exit", std::to_string(options.idle_exit.count())},
      log);
}

/// Waits for the server at `socket`. Starts it if no other process is starting it.
static Status wait_for_server(const PrivateServerOptions& options, const fs::path& data,
                              const fs::path& socket, const Progress& progress) {
  const FileLock starting(data / "window-start.lock");
  if (!starting.is_open())
    return errno_status("cannot open " + (data / "window-start.lock").string(), errno);
  std::optional<DetachedProgram> server;
  bool may_start = false;
  const auto deadline = steady_clock::now() + kPatience;
  while (report(progress, "starting a private server", 0)) {
    ASSIGN_OR_RETURN(const bool answers, user_listens(socket));
    if (answers) return Status::ok();
    may_start = may_start || starting.try_take();
    if (server && server->has_ended())
      return unavailable("the private server ended: " + last_line(data / "window-server.log"));
    if (may_start && !server && !is_taken(data)) {
      ASSIGN_OR_RETURN(DetachedProgram started, start_server(options, data, socket));
      server.emplace(std::move(started));
    }
    if (!server && steady_clock::now() > deadline)
      return unavailable("another burnish-server uses the folder " + data.string() +
                         " but does not listen on " + socket.string());
    std::this_thread::sleep_for(kPoll);
  }
  return cancelled("starting a private server was cancelled");
}

uint64_t private_server_memory_bytes() {
  return machine_memory_bytes() / 2;
}

Result<std::string> find_private_server(const PrivateServerOptions& options,
                                        const Progress& progress) {
  if (options.data.empty())
    return not_found("a private server needs a home folder for its scans, and there is none");
  if (access(server_program().c_str(), X_OK) != 0)
    return not_found("cannot find " + server_program().string() + "; name a server with --server");
  RETURN_IF_ERROR(make_private_folder(options.data));
  const fs::path data = full_path(options.data), socket = private_socket(data);
  if (socket.parent_path() != data) RETURN_IF_ERROR(make_private_folder(socket.parent_path()));
  RETURN_IF_ERROR(wait_for_server(options, data, socket, progress));
  return "unix:" + socket.string();
}

}  // namespace burnish
