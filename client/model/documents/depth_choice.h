#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/mesh/statistics/statistics.h"

namespace burnish {

/// A depth at which a scan may open, in words.
struct DepthChoice {
  int depth = 0;
  std::string text;     ///< "depth 9: details from 0.3 mm, cells of 0.15 mm, about 1.1 GB"
  std::string refusal;  ///< why it does not fit; empty: it fits
  bool is_default = false;
};

/// Returns a choice for each depth from kDepthMin on. `memory_bytes_max` is the server's; 0: not
/// known, then all fit. A depth that may fit is not refused: the server decides. `server_default`
/// is the default depth of a scan of the server; 0: not known, then the choice that it would make.
/// Needs: a box that is not empty. Units: `unit` is that of the coordinates, empty: not named.
std::vector<DepthChoice> depth_choices(const MeshStatistics& scan, const std::string& unit,
                                       uint64_t memory_bytes_max, int server_default);

}  // namespace burnish
