#include "server/rpc/admission/admission.h"

#include <spdlog/spdlog.h>

#include "server/metrics/metrics.h"
#include "server/process/line_limiter.h"

namespace burnish {

static Refusal reason_of(StatusCode code) {
  switch (code) {
    case StatusCode::kPermissionDenied:
      return Refusal::kPermission;
    case StatusCode::kUnimplemented:
      return Refusal::kUnknownRpc;
    case StatusCode::kUnavailable:
      return Refusal::kDraining;
    case StatusCode::kResourceExhausted:
      return Refusal::kLimit;
    default:
      return Refusal::kUnauthenticated;
  }
}

void report_refusal(std::string_view method, std::string_view peer, const Status& why) {
  const Refusal reason = reason_of(why.code());
  // The end of the call counts the others.
  if (reason != Refusal::kLimit) metrics().count_refusal(reason);
  if (may_log(LineKind::kRefusedCall))
    spdlog::warn("refused {}{}{}: {}", method, peer.empty() ? "" : " from ", peer, why.to_string());
}

Status Admission::admit(std::string_view method, const Proof& proof, std::string_view peer) const {
  const Status status = guard_->check(method, proof).status();
  if (status.is_ok()) {
    ++counts_->arrived;
  } else {
    report_refusal(method, peer, status);
  }
  return status;
}

}  // namespace burnish
