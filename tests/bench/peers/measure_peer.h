#pragma once

#include <span>

#include "tests/bench/peers/linear_system.h"
#include "tests/bench/peers/row.h"

namespace burnish::bench {

/// The system that a peer solves, and the shared data of its measurements.
struct PeerTask {
  const LinearSystem* system;
  double assembly_ms;
  double diagonal;  ///< of the bounding box, file units
  uint64_t bytes_max;
};

/// Times a peer at every α. A direct peer adds the missing answers. An iterative peer is compared
/// with them: of the relative residuals 1e-1, 1e-2, ... it stops at the first that settles, which
/// is kinder than any criterion of its own.
std::vector<Row> measure_peer(const PeerKind& kind, const PeerTask& task,
                              std::span<const double> alphas, Answers& answers);

}  // namespace burnish::bench
