#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/evaluation/evaluation.h"
#include "common/grid/morton.h"
#include "common/grid/sparse_grid.h"
#include "server/memory/quota.h"

namespace burnish {

/// A part of the shown surface stays behind by at most so much from the session's surface, over the
/// box's diagonal. With kSettledDistance it stays well below the bar of settled surfaces, 1e-4.
inline constexpr double kSteadyDistance = 1e-5;

/// The surface that a live session shows. After an edit of a small part the solver refines all of
/// a settled surface by less than anybody sees; shown as it is, that would send every page. So a
/// part stays as it was shown until it has moved by more than a distance. All clients and all pages
/// show this one surface: there are no cracks.
class SteadySurface {
 public:
  /// `distance`: in cells. `memory`: byte_count() of the server's. Needs: `grid` and `scan` outlive
  /// it. Shapes: one point per vertex of the scan.
  SteadySurface(const SparseGrid& grid, std::span<const EvaluationPoint> scan, float distance,
                Quota::Share memory);

  /// The surface has come to rest: parts stay behind again until they move.
  void rest();

  /// Moves the parts where a vertex is further than the distance from where it is shown, and all
  /// parts that have moved since rest(). Returns what to show. The first call moves all.
  /// Shapes: one displacement per corner, cells. The result is valid until the next call.
  std::span<const Vec3f> show(std::span<const Vec3f> displacement);

  /// Moves all parts.
  std::span<const Vec3f> show_all(std::span<const Vec3f> displacement);

  /// Returns what the last call returned.
  std::span<const Vec3f> shown() const { return shown_; }

  /// Returns whether a part is not as the last displacement says.
  bool is_behind() const { return is_behind_; }

  /// Returns the bytes of memory that it takes. O(corners).
  static uint64_t byte_count(const SparseGrid& grid);

 private:
  /// A cube of 4³ corners: those from `first` to the next brick's.
  struct Brick {
    MortonKey key;
    size_t first;
  };

  using Marks = std::vector<uint8_t>;

  Marks find_moved_corners(std::span<const Vec3f> displacement) const;
  Marks find_moved_bricks(std::span<const Vec3f> displacement, const Marks& corners) const;
  void move_around(size_t brick);
  void move_bricks(std::span<const Vec3f> displacement);
  std::optional<size_t> find_brick(MortonKey key) const;

  const SparseGrid& grid_;
  std::span<const EvaluationPoint> scan_;
  const float distance_;
  Quota::Share memory_;
  std::vector<Brick> bricks_;  // rising
  Marks moves_;                // per brick: it has moved since rest()
  bool all_move_ = false;      // likewise
  std::vector<Vec3f> shown_;   // empty before the first call
  bool is_behind_ = false;
};

}  // namespace burnish
