#include "client/cli/progress_printer.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace burnish {

static constexpr int kBarWidth = 30;
static constexpr auto kRedrawInterval = std::chrono::milliseconds(100);

ProgressPrinter::ProgressPrinter(ProgressStyle style)
    : style_(style), terminal_(style == ProgressStyle::kText && isatty(STDERR_FILENO) == 1) {}

ProgressPrinter::~ProgressPrinter() {
  if (terminal_ && !phase_.empty()) std::fputs("\r\033[K", stderr);
}

Progress ProgressPrinter::progress() {
  return [this](std::string_view phase, double fraction) {
    show(phase, fraction);
    return true;
  };
}

void ProgressPrinter::show(std::string_view phase, double fraction) {
  const bool begins = phase != phase_;
  phase_ = phase;
  if (!terminal_ && style_ == ProgressStyle::kText) {
    if (begins) std::fprintf(stderr, "%s\n", phase_.c_str());
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (!begins && now - drawn_ < kRedrawInterval) return;
  drawn_ = now;
  const double done = std::clamp(fraction, 0.0, 1.0);
  style_ == ProgressStyle::kJson ? print_line(done) : draw_bar(done);
}

void ProgressPrinter::print_line(double fraction) {
  const nlohmann::ordered_json line = {{"phase", phase_}, {"fraction", fraction}};
  std::fprintf(stderr, "%s\n", line.dump().c_str());
}

void ProgressPrinter::draw_bar(double fraction) {
  const int done = static_cast<int>(fraction * kBarWidth);
  const std::string bar = std::string(static_cast<size_t>(done), '#') +
                          std::string(static_cast<size_t>(kBarWidth - done), '.');
  std::fprintf(stderr, "\r\033[K[%s] %3.0f%% %s", bar.c_str(), 100 * fraction, phase_.c_str());
  std::fflush(stderr);
}

}  // namespace burnish
