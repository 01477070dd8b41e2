#pragma once

#include <memory>
#include <string_view>

#include "common/base/status.h"
#include "server/rpc/admission/call_observer.h"
#include "server/trust/guard.h"

namespace burnish {

/// Logs and counts a refused call. `peer` may be empty: gRPC does not tell it for a call of which
/// it has only the headers.
void report_refusal(std::string_view method, std::string_view peer, const Status& why);

/// Admits calls by their headers, before a byte of their messages is read: messages of strangers
/// cost no memory. Logs and counts refusals. Thread-safe.
class Admission {
 public:
  Admission(std::shared_ptr<const Guard> guard, std::shared_ptr<CallCounts> counts)
      : guard_(std::move(guard)), counts_(std::move(counts)) {}

  /// Fails: as Guard::check(). `peer` may be empty: gRPC does not tell it here.
  Status admit(std::string_view method, const Proof& proof, std::string_view peer = {}) const;

 private:
  const std::shared_ptr<const Guard> guard_;
  const std::shared_ptr<CallCounts> counts_;
};

}  // namespace burnish
