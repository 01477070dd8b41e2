#include "server/live/refused_edits.h"

#include <chrono>
#include <optional>

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/process/minute_limiter.h"

namespace burnish {

static std::optional<Refusal> reason_of_refused_edits(StatusCode code) {
  if (code == StatusCode::kResourceExhausted) return Refusal::kLimit;
  if (code == StatusCode::kPermissionDenied) return Refusal::kPermission;
  return std::nullopt;
}

void report_refused_edits(const EditsRefused& refused) {
  static MinuteLimiter limiter;
  const auto reason = reason_of_refused_edits(refused.status.code());
  if (!reason) return;
  metrics().count_refusal(*reason);
  const bool is_limit = *reason == Refusal::kLimit;
  const auto turn = limiter.take(is_limit ? "limit" : "role", std::chrono::steady_clock::now());
  if (turn.is_admitted)
    spdlog::warn("refused edits of a live client ({} more since the last such line): {}",
                 turn.left_out, refused.status.to_string());
}

}  // namespace burnish
