#include "client/cli/interrupt.h"

#include <csignal>
#include <utility>

namespace burnish {

static volatile std::sig_atomic_t is_interrupted = 0;

static void interrupt(int number) {
  is_interrupted = 1;
  std::signal(number, SIG_DFL);
}

Interrupt::Interrupt() {
  is_interrupted = 0;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, interrupt);
}

Interrupt::~Interrupt() {
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
}

Progress Interrupt::cancelling(Progress next) {
  return [next = std::move(next)](std::string_view phase, double fraction) {
    return is_interrupted == 0 && report(next, phase, fraction);
  };
}

}  // namespace burnish
