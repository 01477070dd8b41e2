#include "server/process/line_limiter.h"

#include <spdlog/spdlog.h>

namespace burnish {

static constexpr uint64_t kLinesPerSecond = 20;

static const char* name_of(LineKind kind) {
  switch (kind) {
    case LineKind::kRefusedCall:
      return "refused calls";
    case LineKind::kEndedCall:
      return "calls that ended";
    case LineKind::kConnection:
      return "connections";
    case LineKind::kTransport:
      break;
  }
  return "messages of gRPC";
}

void LineLimiter::begin_if_over(Second& second, Time now) {
  if (now - second.begin < std::chrono::seconds(1)) return;
  second = {now, 0, 0, second.left_out_before + second.left_out};
}

bool LineLimiter::admit(LineKind kind, Time now) {
  const std::lock_guard lock(mutex_);
  Second& second = seconds_[static_cast<size_t>(kind)];
  begin_if_over(second, now);
  if (second.lines < lines_per_second_) {
    ++second.lines;
    return true;
  }
  ++second.left_out;
  return false;
}

std::vector<std::string> LineLimiter::take_left_out(Time now) {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> told;
  for (size_t i = 0; i < kKinds; ++i) {
    Second& second = seconds_[i];
    begin_if_over(second, now);
    if (second.left_out_before == 0) continue;
    told.push_back(std::to_string(second.left_out_before) + " more lines of " +
                   name_of(static_cast<LineKind>(i)));
    second.left_out_before = 0;
  }
  return told;
}

static LineLimiter& process_limiter() {
  static LineLimiter limiter(kLinesPerSecond);
  return limiter;
}

bool may_log(LineKind kind) {
  return process_limiter().admit(kind, std::chrono::steady_clock::now());
}

void log_left_out_lines() {
  for (const std::string& line : process_limiter().take_left_out(std::chrono::steady_clock::now()))
    spdlog::warn("the log leaves out {}", line);
}

}  // namespace burnish
