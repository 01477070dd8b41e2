#include "client/model/files/native_dialog.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <unistd.h>

#include <sys/wait.h>

namespace burnish {

namespace fs = std::filesystem;

static constexpr int kPollMs = 100;
static constexpr int kCancelled = 1;  // exit code of both programs
static constexpr size_t kAnswerBytesMax = 64 * 1024;

static fs::path program_in_path(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path program = fs::path(folder) / name;
    if (!folder.empty() && access(program.c_str(), X_OK) == 0) return program;
  }
  return {};
}

static std::string patterns_of(const FileQuestion& question) {
  std::string patterns;
  for (const std::string& extension : question.extensions)
    patterns += (patterns.empty() ? "*" : " *") + extension;
  return patterns.empty() ? "*" : patterns;
}

static std::vector<std::string> zenity_words(const FileQuestion& question) {
  const bool saves = question.purpose == FileQuestion::Purpose::kSave;
  std::string start = question.start.string();
  if (!saves && !start.ends_with('/')) start += '/';  // a folder
  std::vector<std::string> words = {"--file-selection", "--title=" + question.title,
                                    "--filename=" + start};
  if (saves) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  if (!question.extensions.empty()) words.push_back("--file-filter=" + patterns_of(question));
  return words;
}

static std::vector<std::string> kdialog_words(const FileQuestion& question) {
  const bool saves = question.purpose == FileQuestion::Purpose::kSave;
  return {"--title", question.title, saves ? "--getsavefilename" : "--getopenfilename",
          question.start.string(), patterns_of(question)};
}

std::vector<std::string> native_dialog(const FileQuestion& question) {
  fs::path program = program_in_path("zenity");
  std::vector<std::string> words = zenity_words(question);
  if (program.empty()) {
    program = program_in_path("kdialog");
    words = kdialog_words(question);
  }
  if (program.empty()) return {};
  words.insert(words.begin(), program.string());
  return words;
}

namespace {

/// A program whose output is read. The destructor ends it.
class AnsweringProgram {
 public:
  static Result<AnsweringProgram> start(const std::vector<std::string>& command) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return errno_status("cannot make a pipe", errno);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t id = 0;
    const int error =
        posix_spawn(&id, command[0].c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    AnsweringProgram program(error == 0 ? id : 0, ends[0]);
    if (error != 0) return errno_status("cannot run " + command[0], error);
    return program;
  }
  AnsweringProgram(AnsweringProgram&& other) noexcept
      : id_(std::exchange(other.id_, 0)), output_(std::exchange(other.output_, -1)) {}
  ~AnsweringProgram() {
    if (output_ >= 0) close(output_);
    if (id_ == 0) return;
    kill(id_, SIGTERM);
    waitpid(id_, nullptr, 0);
  }

  /// Returns false at the end of the output, or when a stop is asked for.
  bool read_more(std::string& text, const StopToken& stop) const {
    pollfd waiting{output_, POLLIN, 0};
    while (poll(&waiting, 1, kPollMs) == 0)
      if (stop.stop_requested()) return false;
    char bytes[1024];
    const ssize_t count = read(output_, bytes, sizeof bytes);
    if (count > 0) text.append(bytes, static_cast<size_t>(count));
    return count > 0 && text.size() < kAnswerBytesMax;
  }

  int wait() {
    int status = 0;
    waitpid(std::exchange(id_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  }

 private:
  AnsweringProgram(pid_t id, int output) : id_(id), output_(output) {}

  pid_t id_;
  int output_;
};

}  // namespace

Result<std::optional<fs::path>> ask_natively(const std::vector<std::string>& command,
                                             const StopToken& stop) {
  ASSIGN_OR_RETURN(AnsweringProgram program, AnsweringProgram::start(command));
  std::string text;
  while (program.read_more(text, stop)) {
  }
  if (stop.stop_requested()) return std::optional<fs::path>();
  const int code = program.wait();
  if (code == kCancelled) return std::optional<fs::path>();
  if (code != 0) return unavailable(command[0] + " ended with exit code " + std::to_string(code));
  text.erase(text.find_last_not_of('\n') + 1);
  return text.empty() ? std::optional<fs::path>() : fs::path(text);
}

}  // namespace burnish
