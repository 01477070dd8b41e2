#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/pages/cut.h"
#include "tests/server/prepare/pages/boundary.h"
#include "tests/server/prepare/pages/read_pages.h"

namespace burnish {

/// Tells whether pictures of legal cuts have cracks. count_cracks() trusts whole levels;
/// count_misfits() tells whether the levels themselves are whole.
class CrackFinder {
 public:
  /// Vertices are moved by a random displacement, which their place decides. Two vertices are one
  /// where their moved positions have the same bits.
  CrackFinder(const ReadPages& read, uint32_t displacement_seed);

  /// Counts the edges on the boundary of a picture that are on the boundary of none of the levels
  /// that draw the edge, or in another way. None: there is no crack. Needs: a legal cut.
  size_t count_cracks(const PageSet& cut) const;

  /// Counts the edges where what replaces a page does not fit the pages around it: edges between
  /// pages that it lacks or passes in another way, and, for a page away from the scan's own
  /// boundary, edges that only the replacement has on its boundary.
  size_t count_misfits() const;

  /// The boundary of one whole level.
  const Boundary& level_boundary(int level) const { return level_boundaries_[level]; }

 private:
  void add_page(const Page& page, uint32_t seed);
  uint32_t number_of(const Vec3i& position, uint32_t seed);

  const ReadPages& read_;
  std::unordered_map<uint64_t, std::vector<std::pair<Vec3f, uint32_t>>> places_;
  uint32_t place_count_ = 0;
  size_t count_misfits(const Boundary& page, const Boundary& replacement, int level) const;

  std::vector<std::vector<Boundary>> patch_boundaries_;  ///< per page and patch
  std::vector<Boundary> level_boundaries_;
};

}  // namespace burnish
