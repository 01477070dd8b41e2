// Loaded into a burnish-server under test (LD_PRELOAD). After SIGUSR1 it kills the server at the
// BURNISH_DIE_COUNT-th arrival at the point BURNISH_DIE_AT: before or after a sync or a rename.
// At the point "before log sync" other files than a journal's log do not count.
// At the point "failed sync" the server lives on: the sync of a journal's log is done, and fails
// with EIO.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <string>
#include <string_view>
#include <unistd.h>

static std::atomic<int> left{-1};  // arrivals until the kill; negative: not armed

static void arm(int) {
  left = std::atoi(std::getenv("BURNISH_DIE_COUNT"));
  static const char said[] = "armed\n";
  (void)!::write(STDERR_FILENO, said, sizeof(said) - 1);
}

__attribute__((constructor)) static void listen_for_signal() {
  std::signal(SIGUSR1, arm);
}

static bool is_wanted(const char* point) {
  const char* wanted = std::getenv("BURNISH_DIE_AT");
  return left > 0 && wanted && std::strcmp(point, wanted) == 0 && --left == 0;
}

static void arrive(const char* point) {
  if (is_wanted(point)) ::raise(SIGKILL);
}

template <typename Function, typename... Arguments>
static int between(const char* before, const char* after, Function real, Arguments... arguments) {
  arrive(before);
  const int result = real(arguments...);
  arrive(after);
  return result;
}

// A checkpoint of SQLite and a prepared file are synced too, and nobody waits for these.
static bool is_log_of_a_journal(int file) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(file);
  const ssize_t length = ::readlink(link.c_str(), path, sizeof(path));
  return length > 0 && std::string_view(path, size_t(length)).ends_with("-wal");
}

static int sync(int (*real)(int), int file) {
  const bool is_log = is_log_of_a_journal(file);
  if (is_log) arrive("before log sync");
  const int result = between("before sync", "after sync", real, file);
  if (!is_log || !is_wanted("failed sync")) return result;
  errno = EIO;
  return -1;
}

extern "C" int fsync(int file) {
  static const auto real = reinterpret_cast<int (*)(int)>(::dlsym(RTLD_NEXT, "fsync"));
  return sync(real, file);
}

extern "C" int fdatasync(int file) {
  static const auto real = reinterpret_cast<int (*)(int)>(::dlsym(RTLD_NEXT, "fdatasync"));
  return sync(real, file);
}

extern "C" int rename(const char* from, const char* to) noexcept {
  using Rename = int (*)(const char*, const char*);
  static const auto real = reinterpret_cast<Rename>(::dlsym(RTLD_NEXT, "rename"));
  return between("before rename", "after rename", real, from, to);
}
