#pragma once

#include <filesystem>
#include <optional>

#include "common/base/status.h"
#include "common/edit/proposed_edges.h"
#include "server/prepare/prepare.h"
#include "server/session/session.h"

namespace burnish {

/// Content of `burnish filter --report`.
struct FilterRun {
  double read_seconds = 0;
  PrepareReport prepare;
  double hierarchy_seconds = 0;
  uint64_t hierarchy_bytes = 0;
  int32_t corners = 0;
  SolveReport solve;
  double write_seconds = 0;
  std::optional<EdgeProposal> proposal;  ///< with --keep-edges auto, and presets that follow noise
  std::optional<double> volume;          ///< over the scan's; nothing unless it is to be kept
};

/// Writes JSON: grid, counts, seconds and peak bytes by phase, memory, cycles, energy and the
/// estimated distance to convergence (fraction of the bounding-box diagonal).
Status write_filter_report(const Session& session, const FilterRun& run,
                           const std::filesystem::path& path);

}  // namespace burnish
