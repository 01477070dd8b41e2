#pragma once

#include <string>

#include "common/mesh/statistics/statistics.h"

namespace burnish {

/// Returns "120 MB" or "1.8 GB".
std::string memory_text(double bytes);

/// Says what a depth leaves out: "the scan's own edges are 0.1 mm; depth 11 matches them and takes
/// about 14 GB more". Ends after the edges if the depth matches them.
/// Needs: a box that is not empty. Units: `unit` is that of the coordinates, empty: not named.
std::string edges_text(const MeshStatistics& scan, const std::string& unit, int depth);

}  // namespace burnish
