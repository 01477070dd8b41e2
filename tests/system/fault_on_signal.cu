// Loaded into a burnish-server under test (LD_PRELOAD). After SIGUSR1 the device fails as after a
// broken kernel, and CUDA's error stays with the process.

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>
#include <unistd.h>

static std::atomic<bool> has_come{false};

static __global__ void trap_kernel() {
  __trap();
}

static void wait_and_fault() {
  while (!has_come) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  trap_kernel<<<1, 1>>>();
}

__attribute__((constructor)) static void listen_for_signal() {
  std::signal(SIGUSR1, [](int) {
    has_come = true;
    static const char said[] = "armed\n";
    (void)!::write(STDERR_FILENO, said, sizeof(said) - 1);
  });
  std::thread(wait_and_fault).detach();
}
