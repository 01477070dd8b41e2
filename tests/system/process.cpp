#include "tests/system/process.h"

#include <csignal>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

#include <sys/resource.h>
#include <sys/wait.h>

#include "common/base/check.h"
#include "tests/common/temporary_folder.h"

namespace burnish {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

static constexpr auto kPollInterval = milliseconds(10);

[[noreturn]] static void become(std::vector<char*> argv, int output,
                                const Process::Limits& limits) {
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  if (limits.file_bytes_max) {
    const rlimit limit = {*limits.file_bytes_max, *limits.file_bytes_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  if (limits.address_bytes_max) {
    const rlimit limit = {*limits.address_bytes_max, *limits.address_bytes_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  execv(argv[0], argv.data());
  _exit(127);
}

Process::Process(const std::vector<std::string>& words, std::filesystem::path output,
                 const Limits& limits)
    : output_(std::move(output)) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const int file = ::open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
  BURNISH_CHECK(file >= 0, "cannot open " + output_.string());
  pid_ = fork();
  BURNISH_CHECK(pid_ >= 0, "cannot fork");
  if (pid_ == 0) become(std::move(argv), file, limits);
  ::close(file);
}

Process::~Process() {
  if (exit_code_) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

std::optional<int> Process::wait(milliseconds time) {
  const auto deadline = steady_clock::now() + time;
  while (!exit_code_) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (steady_clock::now() >= deadline) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(kPollInterval);
    }
  }
  return exit_code_;
}

void Process::signal(int number) const {
  ::kill(pid_, number);
}

std::string Process::output() const {
  return content_of(output_);
}

bool Process::wait_for_output(const std::string& text, milliseconds time) {
  const auto deadline = steady_clock::now() + time;
  while (output().find(text) == std::string::npos) {
    const bool ended = wait(kPollInterval).has_value();
    if (ended) return output().find(text) != std::string::npos;
    if (steady_clock::now() >= deadline) return false;
  }
  return true;
}

}  // namespace burnish
