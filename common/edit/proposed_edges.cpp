#include "common/edit/proposed_edges.h"

#include <cstdio>

namespace burnish {

std::string text_of(const EdgeProposal& proposal) {
  return text_of(proposal, proposal.filter);
}

std::string text_of(const EdgeProposal& proposal, const EdgeFilter& chosen) {
  char noise[80];
  std::snprintf(noise, sizeof noise, "noise about %.2g (%.2f mean edges), ", proposal.noise,
                proposal.noise_in_edges());
  if (!proposal.filter.is_on()) return std::string(noise) + "too little to take away";
  return noise + std::string(proposal.is_machined ? "machined part: " : "") + text_of(chosen);
}

}  // namespace burnish
