#include "server/main/daemon.h"

#include <pthread.h>

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/process/idle_end.h"
#include "server/process/line_limiter.h"
#include "server/process/service_manager.h"

namespace burnish {

using std::chrono::milliseconds;

sigset_t block_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  // A full disk or quota is an error of the write; it must not end the server.
  std::signal(SIGXFSZ, SIG_IGN);
  return signals;
}

/// Returns the signal that came within a tick; 0 for none.
static int wait_for_signal(const sigset_t& signals, milliseconds tick) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(tick);
  const timespec time = {whole.count(), std::chrono::nanoseconds(tick - whole).count()};
  const int signal = sigtimedwait(&signals, nullptr, &time);
  return signal > 0 ? signal : 0;
}

static void count_cut_off_calls(Server& server) {
  const uint64_t calls = server.take_cut_off_calls();
  for (uint64_t i = 0; i < calls; ++i) metrics().count_refusal(Refusal::kCutOff);
  if (calls > 0)
    spdlog::warn(
        "refused {} calls whose message did not arrive whole: it was above the receive limit, "
        "or the client was gone",
        calls);
}

static void end_at_next_signal(const sigset_t& signals) {
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

static void drain(Server& server, const std::string& why, const sigset_t& signals,
                  const DaemonOptions& options) {
  notify_service_manager("STOPPING=1");
  spdlog::info("{}: draining; {} running calls have {} s to end", why, server.running_calls(),
               options.drain_time.count());
  end_at_next_signal(signals);
  server.drain(options.drain_time,
               options.find_successors ? options.find_successors() : Successors());
}

Status watch_over(Server& server, const DeviceWatch& device, const sigset_t& signals,
                  const DaemonOptions& options) {
  const auto watchdog = watchdog_interval();
  auto last_sign = options.clock();
  IdleEnd idle_end(options.idle_max, last_sign);
  notify_service_manager("READY=1");
  for (;;) {
    const int signal = wait_for_signal(signals, options.tick);
    if (signal == SIGTERM || signal == SIGINT) {
      drain(server, strsignal(signal), signals, options);
      return Status::ok();
    }
    if (idle_end.is_over(server.is_in_use(), options.clock())) {
      drain(server, "unused for " + std::to_string(options.idle_max.count()) + " s", signals,
            options);
      return Status::ok();
    }
    if (options.is_abandoned && options.is_abandoned()) {
      drain(server, "the input has ended", signals, options);
      return Status::ok();
    }
    options.tend(signal == SIGHUP);
    count_cut_off_calls(server);
    log_left_out_lines();
    const Status status = device.status();
    if (!status.is_ok()) {
      server.set_serving(false);
      return status.with_context("the solver's device has failed");
    }
    if (watchdog.count() > 0 && options.clock() - last_sign >= watchdog - options.tick) {
      notify_service_manager("WATCHDOG=1");
      last_sign = options.clock();
    }
  }
}

}  // namespace burnish
