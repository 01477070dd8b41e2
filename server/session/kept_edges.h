#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/grid/sparse_grid.h"
#include "server/fields/fields.h"
#include "server/session/edge_parts.h"

namespace burnish {

/// What keeps edges while a surface is denoised: filtered normals, the layer of moves towards them,
/// and the gradients that the solver should reach. Costs nothing before edges are first kept.
class KeptEdges {
 public:
  /// `threads`: of a filter, 0: all cores. Needs: `grid` outlives this.
  KeptEdges(std::shared_ptr<const PreparedMesh> prepared, const SparseGrid& grid, int threads);
  /// Ends the other thread's work.
  ~KeptEdges();

  /// Makes what is missing for the fields' filter and for what is held. A filter of another kind,
  /// angle or number of passes filters the normals anew; another crispness fits gradients; another
  /// strength costs nothing. Fails: cancelled, resource_exhausted; then all stays as it was.
  Status want(const Fields& fields, const Progress& progress = {});

  /// Takes the fields as far as their filter is made, and lets another thread make the rest; until
  /// then the last filter counts. `edited`: the filter without previews. A preview of other normals
  /// makes none. Fails: resource_exhausted, once, if the other thread had no memory.
  Status show(const Fields& fields, const EdgeFilter& edited);

  /// Returns whether another thread makes something. The next show() after its end takes that.
  bool is_making() const { return work_.has_value(); }
  bool has_made() const { return is_made_within(std::chrono::milliseconds(0)); }
  bool is_made_within(std::chrono::milliseconds time) const;

  bool is_on() const { return filter_.is_on() && parts_; }

  /// Returns the solver's part. Valid until the next want() or show().
  TargetView target() const;

  /// Returns how much of the layer counts at most: strength times crispness.
  double layer_share() const { return is_on() ? filter_.strength * parts_->filter.crispness : 0; }

  /// Adds the layer to the vertices, except around triangles that would turn by more than 90
  /// degrees against the scan's with it. Shapes: one per vertex, file units.
  void add_layer(std::span<Vec3d> positions) const;

  /// Returns what add_layer() adds. Without positions it leaves no triangle out.
  std::vector<Vec3f> layer(std::span<const Vec3d> positions) const;

  uint64_t byte_count() const;

 private:
  using Made = Result<std::shared_ptr<const EdgeParts>>;
  /// The filter that another thread makes.
  struct Work {
    EdgeFilter filter;
    std::shared_ptr<std::atomic<bool>> is_left;
    std::future<Made> made;
  };

  bool is_missing(const EdgeFilter& filter) const;
  Status wait_for_work(const EdgeFilter& filter, const Progress& progress);
  Status take_made();
  void begin(const EdgeFilter& filter);
  void leave_work();
  void set(const EdgeFilter& filter, const std::shared_ptr<const Hold>& hold);
  void hold(const std::shared_ptr<const Hold>& hold);
  void free_vertices(const Hold& hold);
  std::vector<float> free_shares() const;
  std::vector<float> shares(std::span<const Vec3d> positions) const;
  bool stop_turned(std::span<const Vec3d> positions, std::vector<float>& part) const;

  const std::shared_ptr<const PreparedMesh> prepared_;
  const SparseGrid& grid_;
  const int threads_;
  EdgeFilter filter_;  // its strength counts, with the parts of perhaps another filter
  std::shared_ptr<const EdgeParts> parts_;
  std::shared_ptr<const EdgeParts> held_parts_;  // that cells_ and free_ are of
  std::vector<TargetGradient> cells_;  // the parts' target, less where cells are held; empty: none
  std::vector<float> free_;            // one per vertex: 0 where it is held; empty: all are free
  std::shared_ptr<const Hold> hold_;
  uint64_t version_ = 0;
  std::optional<Work> work_;
};

}  // namespace burnish
