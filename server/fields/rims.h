#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// A hole with a rim below so many mean edges is a flaw of the scan, and is not held: it would stay
/// as a rough spot in a smoothed surface (docs/solver.md, section 10).
inline constexpr double kHeldRimEdgesMin = 12;

/// The rims that stay where they are. A rim is where the surface ends. The rule has the scan's own
/// lengths, so every depth holds the same.
struct HeldRims {
  uint64_t rims = 0;               ///< of the scan; edges that meet are one rim
  uint64_t held = 0;               ///< of these
  std::vector<LineMass> lines;     ///< of the held ones, by rising cell
  std::vector<int32_t> first;      ///< see first_lines()
  std::vector<uint32_t> vertices;  ///< on the held ones, rising: they do not move
  std::vector<uint32_t> places;    ///< of these, one at each place

  LineView view() const { return {lines, first}; }
  uint64_t byte_count() const {
    return lines.size() * sizeof(LineMass) + first.size() * sizeof(int32_t) +
           (vertices.size() + places.size()) * sizeof(uint32_t);
  }
};

/// Holds all rims but those of small holes and those that lie on another piece: raw scans overlap
/// there. The longest rim of a piece is its border, however short.
HeldRims find_held_rims(const PreparedMesh& prepared);

/// "all 5 rims stay where they are", or with the number of the others and why they move.
std::string describe(const HeldRims& rims);

/// Returns the bytes that find_held_rims() takes at its peak. `rims`: no fewer edges than it finds.
/// Accuracy: no less than it takes at the default depth and above it.
uint64_t held_rims_bytes(uint64_t vertices, uint64_t triangles, uint64_t cells, uint64_t rims);

/// Returns whether the surface encloses a volume: it has no rim, and its triangles agree on the
/// outside.
bool is_closed(const PreparedMesh& prepared);

}  // namespace burnish
