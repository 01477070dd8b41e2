#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/peers/peer.h"

namespace burnish::bench {

/// The edits of every solver, in this order, each from the state before it.
enum EditKind { kSmooth, kSliderStep, kMetricStep, kEdits };
inline constexpr std::array<std::string_view, kEdits> kEditNames = {"beta 1 to 0", "beta 0 to 0.1",
                                                                    "alpha x 1.25 at beta 0"};
inline constexpr double kSliderStepBeta = 0.1;
inline constexpr double kMetricStepFactor = 1.25;

/// A solver has settled at this largest distance of a vertex over the bounding box's diagonal.
inline constexpr double kSettledBar = 1e-4;

/// Over the vertices, in parts of the bounding box's diagonal.
struct Distance {
  double max = 0;
  double rms = 0;
};

struct EditTime {
  double update_ms = 0;  ///< the new system: right side, matrix, factors or preconditioner
  double solve_ms = 0;
  int iterations = 0;  ///< 0 for a direct solver
  Distance error;      ///< to the direct solution of the same system

  double total_ms() const { return update_ms + solve_ms; }
};

/// One line of the table: one solver at one α.
struct Row {
  std::string name;
  int threads = 1;
  double alpha = 0;
  double setup_ms = 0;   ///< once per scan: assembly and analysis; ours: preparation
  double factor_ms = 0;  ///< once per metric: factors or preconditioner; ours: matrices
  std::array<EditTime, kEdits> edits;
  uint64_t byte_count = 0;
  std::string note;
  std::string failure;  ///< reason for missing figures, else empty
};

/// Vertex moves at β = 0 by α, from a direct solver. Shapes: vertices × 3. Units: the file's.
using Answers = std::map<double, MatrixXd>;

Distance distance_between(const MatrixXd& a, const MatrixXd& b, double diagonal);

}  // namespace burnish::bench
