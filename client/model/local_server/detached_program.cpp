#include "client/model/local_server/detached_program.h"

#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include <sys/stat.h>
#include <sys/wait.h>

namespace burnish {

static constexpr int kFirstFree = 3;  // first descriptor after the outputs

// Runs between fork and exec. Must not allocate or lock: another thread may have held a lock at the
// fork.
[[noreturn]] static void become(char* const* words, const char* log, int life) {
  umask(S_IRWXG | S_IRWXO);
  const int input = open("/dev/null", O_RDONLY);
  const int output = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0600);
  const int kept = fcntl(life, F_DUPFD, kFirstFree);  // stays open
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (kept > kFirstFree) close_range(kFirstFree, static_cast<unsigned>(kept) - 1, 0);
  close_range(static_cast<unsigned>(kept) + 1, ~0U, 0);
  if (chdir("/") == 0) execv(words[0], words);
  _exit(127);
}

Result<DetachedProgram> DetachedProgram::start(const std::vector<std::string>& words,
                                               const std::filesystem::path& log) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0) return errno_status("cannot start " + words[0], errno);
  DetachedProgram program(pipe[0]);
  const pid_t pid = fork();
  if (pid == 0) {
    // The parent of the second child has ended, so nobody has to wait for the second child.
    setsid();
    if (fork() == 0) become(arguments.data(), log.c_str(), pipe[1]);
    _exit(0);
  }
  const int error = errno;
  close(pipe[1]);
  if (pid < 0) return errno_status("cannot start " + words[0], error);
  waitpid(pid, nullptr, 0);
  return program;
}

DetachedProgram::DetachedProgram(DetachedProgram&& other) noexcept
    : life_(std::exchange(other.life_, -1)) {}

DetachedProgram::~DetachedProgram() {
  if (life_ >= 0) close(life_);
}

bool DetachedProgram::has_ended() const {
  pollfd wait = {life_, POLLIN, 0};
  return poll(&wait, 1, 0) == 1;
}

}  // namespace burnish
