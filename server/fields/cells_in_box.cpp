#include "server/fields/cells_in_box.h"

#include <algorithm>

#include "common/grid/morton.h"

namespace burnish {
namespace {

/// The cells of each octant of the grid are a range of the Morton order.
class CellsInBox {
 public:
  CellsInBox(std::span<const MortonKey> cells, const GridFrame& frame, const AxisBox& box)
      : cells_(cells), least_(frame.to_grid(box.least)), most_(frame.to_grid(box.most)) {
    add(0, frame.depth, 0, static_cast<int64_t>(cells.size()));
  }

  /// Rising.
  const std::vector<int64_t>& found() const { return found_; }

 private:
  static constexpr int kLeafDepth = 2;  // an octant of 4³ cells is taken as a whole

  void add(MortonKey first, int depth, int64_t begin, int64_t end) {
    const Vec3d low = morton_point(first).cast<double>();
    const Vec3d high = low + Vec3d::Constant(1 << depth);
    if (begin == end || (low.array() > most_.array()).any() ||
        (high.array() < least_.array()).any())
      return;
    if (depth <= kLeafDepth) {
      for (int64_t c = begin; c < end; ++c) found_.push_back(c);
      return;
    }
    const MortonKey keys = MortonKey{1} << 3 * (depth - 1);  // per child
    for (MortonKey child = first; child < first + 8 * keys; child += keys) {
      const auto stop =
          std::lower_bound(cells_.begin() + begin, cells_.begin() + end, child + keys);
      const int64_t child_end = stop - cells_.begin();
      add(child, depth - 1, begin, child_end);
      begin = child_end;
    }
  }

  std::span<const MortonKey> cells_;
  Vec3d least_, most_;  // grid units
  std::vector<int64_t> found_;
};

}  // namespace

AxisBox box_of(std::span<const Vec3d> centres, double radius) {
  AxisBox box{centres.front(), centres.front()};
  for (const Vec3d& centre : centres) {
    box.least = box.least.cwiseMin(centre);
    box.most = box.most.cwiseMax(centre);
  }
  return {box.least - Vec3d::Constant(radius), box.most + Vec3d::Constant(radius)};
}

std::vector<int64_t> cells_in(const AxisBox& box, const PreparedMesh& prepared) {
  return CellsInBox(prepared.cells, prepared.frame, box).found();
}

}  // namespace burnish
