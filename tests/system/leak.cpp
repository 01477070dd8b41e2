// Loaded into a burnish-server under test (LD_PRELOAD): leaks 256 KiB with each connection.

#include <cstdlib>
#include <cstring>
#include <dlfcn.h>

#include <sys/socket.h>

static void* volatile lost;  // volatile, or the compiler would remove the leak

extern "C" int accept4(int socket, sockaddr* address, socklen_t* size, int flags) {
  using Accept = int (*)(int, sockaddr*, socklen_t*, int);
  static const auto real = reinterpret_cast<Accept>(::dlsym(RTLD_NEXT, "accept4"));
  static constexpr size_t kBytes = size_t{256} << 10;
  const int connection = real(socket, address, size, flags);
  if (connection < 0) return connection;
  lost = std::malloc(kBytes);
  std::memset(lost, 1, kBytes);
  return connection;
}
