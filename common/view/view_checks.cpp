#include <algorithm>
#include <cmath>

#include "common/base/limits.h"
#include "common/grid/sparse_grid.h"
#include "common/view/view_format.h"

namespace burnish {

namespace {

// The index of a corner must fit int32, and a cell has eight corners.
constexpr uint64_t kViewCellsMax = uint64_t{1} << 28;

Status wrong(const std::string& what) {
  return data_loss("view: " + what);
}

Status check_range(const std::string& name, double value, double least, double most) {
  if (value >= least && value <= most) return Status::ok();  // false for NaN
  return wrong(name + " " + std::to_string(value) + " is outside " + std::to_string(least) + ".." +
               std::to_string(most));
}

Status check_scalars(const ViewParts& parts) {
  // Side of a cube around coordinates of the largest size.
  constexpr double kReach = 4 * kCoordinateMagnitudeMax;
  constexpr double kLeast = std::numeric_limits<double>::min();
  RETURN_IF_ERROR(check_range("depth", parts.frame.depth, kDepthMin, kDepthMax));
  RETURN_IF_ERROR(check_range("cell size", parts.frame.cell_size, kLeast, kReach));
  RETURN_IF_ERROR(check_range("length unit", parts.length_unit, kLeast, kReach));
  for (const double origin : parts.frame.origin)
    RETURN_IF_ERROR(check_range("origin", origin, -kReach, kReach));
  return Status::ok();
}

Status check_count(const std::string& name, uint64_t count, uint64_t wanted) {
  if (count == wanted) return Status::ok();
  return wrong("section " + name + " has " + std::to_string(count) + " elements, not " +
               std::to_string(wanted));
}

Status check_counts(const ViewParts& parts) {
  const auto strays = static_cast<uint64_t>(std::ranges::count(parts.homes, kNone));
  RETURN_IF_ERROR(check_count("locals", parts.locals.size(), parts.homes.size()));
  RETURN_IF_ERROR(check_count("strays", parts.strays.size(), strays));
  if (!parts.colours.empty())
    RETURN_IF_ERROR(check_count("colours", parts.colours.size(), parts.homes.size()));
  if (parts.cells.size() > kViewCellsMax)
    return wrong("section cells has " + std::to_string(parts.cells.size()) +
                 " elements, the limit is " + std::to_string(kViewCellsMax));
  if (parts.homes.size() > parts.scan_vertices || parts.triangles.size() > parts.scan_triangles)
    return wrong("has more vertices or triangles than its scan, which has " +
                 std::to_string(parts.scan_vertices) + " and " +
                 std::to_string(parts.scan_triangles));
  return Status::ok();
}

Status check_cells(const ViewParts& parts) {
  const MortonKey end = MortonKey{1} << 3 * parts.frame.depth;
  for (size_t c = 0; c < parts.cells.size(); ++c) {
    if (parts.cells[c] >= end)
      return wrong("cell " + std::to_string(c) + " is outside the grid of depth " +
                   std::to_string(parts.frame.depth));
    if (c > 0 && parts.cells[c] <= parts.cells[c - 1])
      return wrong("the key of cell " + std::to_string(c) + " is not above the one before it");
  }
  return Status::ok();
}

Status check_triangles(const ViewParts& parts) {
  for (size_t t = 0; t < parts.triangles.size(); ++t)
    for (const uint32_t vertex : parts.triangles[t])
      if (vertex >= parts.homes.size())
        return wrong("triangle " + std::to_string(t) + " refers to vertex " +
                     std::to_string(vertex) + " of " + std::to_string(parts.homes.size()));
  return Status::ok();
}

Status check_vertices(const ViewParts& parts) {
  const auto cells = static_cast<int32_t>(parts.cells.size());
  for (size_t v = 0; v < parts.homes.size(); ++v) {
    const std::string vertex = "vertex " + std::to_string(v);
    if (parts.homes[v] < kNone || parts.homes[v] >= cells)
      return wrong(vertex + " lies in cell " + std::to_string(parts.homes[v]) + " of " +
                   std::to_string(cells));
    for (const float local : parts.locals[v])
      if (!(local >= 0 && local <= 1))
        return wrong(vertex + " lies at " + std::to_string(local) + " of its cell");
  }
  for (const auto& stray : parts.strays)
    for (const double coordinate : stray)
      if (!(std::abs(coordinate) <= kCoordinateMagnitudeMax))
        return wrong("a vertex in no cell lies at " + std::to_string(coordinate));
  return Status::ok();
}

}  // namespace

Status check_view(const ViewParts& parts) {
  RETURN_IF_ERROR(check_scalars(parts));
  RETURN_IF_ERROR(check_counts(parts));
  RETURN_IF_ERROR(check_cells(parts));
  RETURN_IF_ERROR(check_triangles(parts));
  return check_vertices(parts);
}

}  // namespace burnish
