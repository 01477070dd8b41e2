#pragma once

#include <nlohmann/json.hpp>

#include "common/mesh/statistics/statistics.h"

namespace burnish {

/// Prints a line for each depth: cell size, shortest wave, and about how many cells, how much
/// memory and how long preparing takes. Marks the default depth.
void print_depths(const MeshStatistics& statistics, int default_depth);

/// Returns the same as an array. Units: scan units, bytes, seconds.
nlohmann::ordered_json depths_to_json(const MeshStatistics& statistics, int default_depth);

}  // namespace burnish
