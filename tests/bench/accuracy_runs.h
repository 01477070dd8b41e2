#pragma once

#include <string>
#include <variant>
#include <vector>

#include "common/edit/edit.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The end of a run, and its bar.
struct AccuracyStop {
  enum class Kind { kFrames, kSettled, kExact };
  Kind kind = Kind::kFrames;
  int frames = 0;  ///< since the last edit, for kFrames
  double max = 0;  ///< over the bounding-box diagonal
  double rms = 0;  ///< 0 for no bar
};

using Changes = std::vector<decltype(Edit::change)>;

/// One session's life: edits from which it first settles (none: a cold start), later edits, and the
/// moments when its distance from the converged surface is measured.
struct AccuracyRun {
  std::string name;
  Changes settled_with;
  Changes then;
  std::vector<AccuracyStop> stops;
};

/// Returns every row of the accuracy table (docs/solver.md, "How exact"); runs of one metric are
/// neighbours.
std::vector<AccuracyRun> accuracy_runs(const PreparedMesh& prepared);

/// Curves of contrast 100 and 1000 around the curvatures of a scan's detail.
TransferCurve contrast_100();
TransferCurve contrast_1000();

}  // namespace burnish
