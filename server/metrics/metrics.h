#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace burnish {

/// Measured quantities; the exporter makes a histogram of each.
enum class Measure {
  kJournalCommitSeconds,
  kDatabaseRoundTripSeconds,  ///< of a heartbeat in a fleet
  kAssembleSeconds,           ///< matrices and constraint of one solve
  kSolveSeconds,              ///< cycles of one solve
  kResidual,                  ///< relative, at the end of a solve
  kFrameAssembleSeconds,      ///< matrices and constraint of one turn of a live session
  kFrameSolveSeconds,
  kFrameEncodeSeconds,  ///< of one client's frame
  kFrameBytes,
};

/// Reasons for refusals.
enum class Refusal {
  kUnauthenticated,
  kPermission,
  kUnknownRpc,
  kLimit,  ///< of one user or of the whole server
  kDraining,
  kMalformed,     ///< not a message of its type, or in the wrong place of its stream
  kCutOff,        ///< the message was above the receive limit, or its client left meanwhile
  kConnections,   ///< above connections_max
  kHandshake,     ///< no TLS, or a wrong certificate
  kHost,          ///< the web gateway: the header Host has a name that is not the server's
  kKeptSessions,  ///< no place for a session: the user's share, or the server's
  kHistory,       ///< a session or a user has too many bytes of edits
  kOrigin,        ///< the web gateway: a page of another origin
};

/// Counted things.
enum class Count {
  kWebSockets,        ///< that were opened
  kWebCalls,          ///< that were let in through them
  kWebReceivedBytes,  ///< of their frames
  kWebSentBytes,
  kSessionsClaimed,  ///< of a fleet, that no server had
  kFencedAppends,    ///< of a session that another server had taken
  kCallsMoved,       ///< to the server that has their session
  kFallBacks,        ///< of solvers whose step was not sound
};

/// One finished RPC.
struct CallRecord {
  std::string_view method;  ///< "/burnish.v1.Library/ListScans"
  std::string_view code;    ///< "OK", "NOT_FOUND", ...
  double seconds = 0;
  uint64_t bytes_received = 0;
  uint64_t bytes_sent = 0;
};

/// The sink of figures. A source of figures need not know who collects them. Thread-safe. This base
/// class keeps nothing.
class Metrics {
 public:
  virtual ~Metrics() = default;
  virtual void count_call(const CallRecord& /*call*/) {}
  virtual void count_refusal(Refusal /*reason*/) {}
  virtual void add(Count /*what*/, uint64_t /*number*/) {}
  virtual void observe(Measure /*what*/, double /*value*/) {}
};

/// Returns the process's metrics.
Metrics& metrics();

/// Replaces them; null: keeps none. Needs: no thread still uses the old ones.
void set_metrics(std::shared_ptr<Metrics> kept);

}  // namespace burnish
