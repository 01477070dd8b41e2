#pragma once

#include <string>

#include "common/denoise/denoise.h"

namespace burnish {

/// A filter that a scan's own noise and edges ask for, and what was read from them.
struct EdgeProposal {
  double noise = 0;      ///< noise_deviation(), file units
  double mean_edge = 0;  ///< file units
  bool is_machined = false;
  EdgeFilter filter;  ///< off if there is no noise to speak of

  double noise_in_edges() const { return noise / mean_edge; }
};

/// Proposes a filter by the scan's own noise. A scan is machined if nearly all bends of its guided
/// normals are about right angles; then the preset for such parts is proposed. Other scans lose
/// detail by every pass, so they get as few as their noise needs, and a wider edge angle only where
/// noise turns normals that far. Fails: cancelled; resource_exhausted without memory.
Result<EdgeProposal> propose_edges(const DenoiseSurface& surface, const ScratchSpace& space = {},
                                   const Progress& progress = {});

/// Describes it in a few words: "noise about 0.12 (0.2 mean edges), machined part: edges kept at
/// strength 1, angle 35, 10 passes, crispness 1, machined".
std::string text_of(const EdgeProposal& proposal);

}  // namespace burnish
