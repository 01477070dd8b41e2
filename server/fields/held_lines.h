#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Integrates B_a B_b along lines, in the cells that they pass.
class HeldLines {
 public:
  explicit HeldLines(const PreparedMesh& prepared) : prepared_(prepared) {}

  /// Adds the line between two points of the surface. Parts of it in cells without surface, or with
  /// several sheets, hold nothing. Units: grid.
  void add(const Vec3d& from, const Vec3d& to);

  /// Returns the lines of all cells, by rising cell. Ends the adding.
  std::vector<LineMass> take();

 private:
  const PreparedMesh& prepared_;
  std::vector<LineMass> parts_;
};

/// Returns the first line of each stretch of cells. Shapes: one per LineView::kStretch cells, and
/// the end.
std::vector<int32_t> first_lines(std::span<const LineMass> lines, size_t cells);

}  // namespace burnish
