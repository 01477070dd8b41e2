#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy.h"

namespace burnish {

/// Leaves converged sessions of α 1, α 50 and a curve of contrast 1000 idle for 2,000 frames and
/// prints what rose, drifted or ran away. Returns how many missed: energy that rose beyond
/// rounding, a vertex that moved by more than the bar of exports, a corner that ran away.
int soak(std::shared_ptr<const PreparedMesh> prepared, std::shared_ptr<const Hierarchy> hierarchy,
         nlohmann::ordered_json& out);

}  // namespace burnish
