#pragma once

#include <memory>
#include <string_view>

#include "server/rpc/call_observer.h"
#include "server/trust/guard.h"

namespace burnish {

/// Lets calls in by their headers, before a byte of their messages is read: what a stranger sends
/// costs no memory. Refusals are logged and counted. Thread-safe.
class Admission {
 public:
  Admission(std::shared_ptr<const Guard> guard, std::shared_ptr<CallCounts> counts)
      : guard_(std::move(guard)), counts_(std::move(counts)) {}

  /// Fails as Guard::check().
  Status admit(std::string_view method, const Proof& proof) const;

 private:
  const std::shared_ptr<const Guard> guard_;
  const std::shared_ptr<CallCounts> counts_;
};

}  // namespace burnish
