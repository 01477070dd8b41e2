#pragma once

#include <span>

#include "tests/bench/peers/linear_system.h"
#include "tests/bench/peers/row.h"

namespace burnish::bench {

/// The system that a peer is measured on, and what all measurements of it share.
struct PeerTask {
  const LinearSystem* system;
  double assembly_ms;
  double diagonal;  ///< of the bounding box, file units
  uint64_t bytes_max;
};

/// Times a peer at every α. A direct peer adds the answers that are still missing; an iterative one
/// is held to them: of the relative residuals 1e-1, 1e-2, ... it stops at the first that settles,
/// which is kinder than any criterion that it could apply by itself.
std::vector<Row> measure_peer(const PeerKind& kind, const PeerTask& task,
                              std::span<const double> alphas, Answers& answers);

}  // namespace burnish::bench
