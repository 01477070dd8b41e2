#pragma once

#include <nlohmann/json.hpp>

#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Leaves converged sessions of α 1, α 50 and a curve of contrast 1000 idle for 2,000 frames.
/// Prints all rises, drifts and growth. Returns the number of misses: energy that rose beyond
/// rounding, a vertex that moved by more than the bar of exports, a corner that ran away.
int soak(const Multigrid& on, nlohmann::ordered_json& out);

}  // namespace burnish
