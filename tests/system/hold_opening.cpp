// Loaded into a burnish-server under test (LD_PRELOAD). It opens no kept hierarchy until the file
// BURNISH_GATE is there: sessions wait as those of a very large scan do.

#include <cstdarg>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

static void wait_at_gate(std::string_view path) {
  constexpr useconds_t kPause = 5'000;
  const char* const gate = std::getenv("BURNISH_GATE");
  while (gate && path.ends_with(".hierarchy") && ::access(gate, F_OK) != 0) ::usleep(kPause);
}

using Open = int (*)(const char*, int, ...);

static int open_beyond_gate(const char* name, const char* path, int flags, va_list more) {
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;
  wait_at_gate(path);
  return reinterpret_cast<Open>(::dlsym(RTLD_NEXT, name))(path, flags, mode);
}

extern "C" int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const int file = open_beyond_gate("open", path, flags, more);
  va_end(more);
  return file;
}

extern "C" int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const int file = open_beyond_gate("open64", path, flags, more);
  va_end(more);
  return file;
}
