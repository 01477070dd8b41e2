// Checks of changes of the fields.

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "common/grid/morton.h"
#include "server/fields/cell_index.h"
#include "server/fields/fields.h"

namespace burnish {

static std::string text_of(const Vec3i& cell) {
  return std::to_string(cell.x()) + " " + std::to_string(cell.y()) + " " + std::to_string(cell.z());
}

Status Fields::check(const SetCellFields& change) const {
  for (const SetCellFields::Cell& cell : change.cells)
    RETURN_IF_ERROR(index_of_cell(prepared_, cell.cell).status());
  return Status::ok();
}

Status Fields::check_new(const SetCellFields& change) const {
  if (change.cells.size() > prepared_.cells.size())
    return invalid_argument("the edit sets " + std::to_string(change.cells.size()) +
                            " cells, the limit is " + std::to_string(prepared_.cells.size()));
  std::vector<char> is_set(prepared_.cells.size());
  for (const SetCellFields::Cell& cell : change.cells) {
    ASSIGN_OR_RETURN(const int32_t index, index_of_cell(prepared_, cell.cell));
    if (std::exchange(is_set[index], 1) != 0)
      return invalid_argument("the edit sets cell " + text_of(cell.cell) + " twice");
  }
  return Status::ok();
}

bool Fields::touches(const Stroke& stroke, const std::function<bool(int64_t)>& is_asked) const {
  static constexpr size_t kReachedMax = 1 << 18;  // a tenth of a second
  if (!ball_touches(stroke, is_asked)) return false;
  if (!stroke.brush.connected) return true;
  const std::vector<Vec3d> centres = dab_centres(stroke);
  SurfaceNear near(prepared_, cells_near(stroke.brush, centres));
  size_t reached = 0;
  const auto is_asked_near = [&](const SurfaceNear::Reached& cell) {
    return is_asked(near.cells()[cell.index]);
  };
  for (const Vec3d& centre : centres) {
    near.begin(centre, stroke.brush.radius);
    for (auto ring = near.next_ring(); !ring.empty(); ring = near.next_ring()) {
      if (std::ranges::any_of(ring, is_asked_near)) return true;
      reached += ring.size();
      if (reached > kReachedMax) return true;
    }
  }
  return false;
}

// A fine brush on the surface may reach the middle of no cell: it touches the surface all the same.
bool Fields::ball_touches(const Stroke& stroke,
                          const std::function<bool(int64_t)>& is_asked) const {
  const auto is_reached = [&](const Vec3d& centre, int64_t c) {
    const Vec3d corner = prepared_.frame.to_file(morton_point(prepared_.cells[c]).cast<double>());
    const Vec3d end = corner + Vec3d::Constant(prepared_.frame.cell_size);
    return (centre.cwiseMax(corner).cwiseMin(end) - centre).norm() < stroke.brush.radius;
  };
  return std::ranges::any_of(dab_centres(stroke), [&](const Vec3d& centre) {
    return std::ranges::any_of(cells_near(stroke.brush, {&centre, 1}),
                               [&](int64_t c) { return is_asked(c) && is_reached(centre, c); });
  });
}

Status Fields::check_new(const Stroke& stroke) const {
  if (ball_touches(stroke, [](int64_t) { return true; })) return Status::ok();
  std::ostringstream text;
  text << "the stroke touches nothing: no part of the surface is within the brush's radius, "
       << stroke.brush.radius << ", of its path";
  return invalid_argument(text.str());
}

}  // namespace burnish
