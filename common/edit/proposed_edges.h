#pragma once

#include <string>

#include "common/edit/edge_filter.h"

namespace burnish {

/// The word for edges that are kept as the scan's own noise asks.
inline constexpr const char* kAutoEdges = "auto";
/// The word for edges that are not kept.
inline constexpr const char* kNoEdges = "off";

/// The filter that a scan's own noise and edges ask for, and what was read from them.
struct EdgeProposal {
  double noise = 0;      ///< deviation along the normals of the flatter parts, file units
  double mean_edge = 0;  ///< file units
  bool is_machined = false;
  EdgeFilter filter;  ///< off if there is no noise to speak of
  bool operator==(const EdgeProposal&) const = default;

  double noise_in_edges() const { return noise / mean_edge; }
};

/// Describes it in a few words: "noise about 0.12 (0.2 mean edges), machined part: edges kept at
/// strength 1, angle 35, 10 passes, crispness 1, machined".
std::string text_of(const EdgeProposal& proposal);
/// Does the same where this filter takes the place of the proposed one.
std::string text_of(const EdgeProposal& proposal, const EdgeFilter& chosen);

}  // namespace burnish
