#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace burnish {

/// What is measured wherever it happens; the exporter makes a histogram of each.
enum class Measure {
  kJournalCommitSeconds,
  kAssembleSeconds,       ///< matrices and constraint of one solve
  kSolveSeconds,          ///< its cycles
  kResidual,              ///< relative, at its end
  kFrameAssembleSeconds,  ///< the same of one turn of a live session
  kFrameSolveSeconds,
  kFrameEncodeSeconds,  ///< of one client's frame
  kFrameBytes,
};

/// Why somebody was turned away.
enum class Refusal {
  kUnauthenticated,
  kPermission,
  kUnknownRpc,
  kLimit,  ///< of one user or of the whole server
  kDraining,
  kMalformed,    ///< no message of its type, or one that its stream does not take
  kCutOff,       ///< the message was above the receive limit, or its client went while it came
  kConnections,  ///< above connections_max
  kHandshake,    ///< no TLS, or a certificate that is not good
};

/// One RPC that has ended.
struct CallRecord {
  std::string_view method;  ///< "/burnish.v1.Library/ListScans"
  std::string_view code;    ///< "OK", "NOT_FOUND", ...
  double seconds = 0;
  uint64_t bytes_received = 0;
  uint64_t bytes_sent = 0;
};

/// Where figures go. Whoever has one to tell needs to know nothing of who collects them.
/// Thread-safe. This one keeps nothing.
class Metrics {
 public:
  virtual ~Metrics() = default;
  virtual void count_call(const CallRecord& /*call*/) {}
  virtual void count_refusal(Refusal /*reason*/) {}
  virtual void observe(Measure /*what*/, double /*value*/) {}
};

/// The process's metrics, as the log is the process's log.
Metrics& metrics();

/// Replaces them; null: none are kept. Needs: no thread still uses the last ones.
void set_metrics(std::shared_ptr<Metrics> kept);

}  // namespace burnish
