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
#include "server/session/edge_strength.h"
#include "server/solver/solver.h"

namespace burnish {

/// Keeps edges while a surface is denoised: filtered normals, the layer of moves towards them,
/// and the gradients that the solver should reach. Costs nothing before edges are first kept.
class KeptEdges {
 public:
  /// `backend`: where filters run, as SolverOptions has it. `threads`: of a filter, 0: all cores.
  /// Needs: `grid` outlives this.
  KeptEdges(std::shared_ptr<const PreparedMesh> prepared, const SparseGrid& grid,
            BackendKind backend, int threads);
  /// Ends the other thread's work.
  ~KeptEdges();

  /// Makes what is missing for the fields' filter, for its paint and for what is held. A filter of
  /// another kind, angle or number of passes filters the normals anew; another crispness fits
  /// gradients; another strength costs nothing. Fails: as make_edge_parts()
  /// does; then all stays as it was.
  Status want(const Fields& fields, const Progress& progress = {});

  /// Takes the fields as far as their filter is made, and lets another thread make the rest; until
  /// then the last filter counts. `edited`: the fields without previews. A preview makes no
  /// normals. Fails: once, as the other thread failed: resource_exhausted,
  /// internal_error.
  Status show(const Fields& fields, const Fields& edited);

  /// Returns whether another thread makes something. The next show() after its end takes that.
  bool is_making() const { return work_.has_value(); }
  bool has_made() const { return is_made_within(std::chrono::milliseconds(0)); }
  bool is_made_within(std::chrono::milliseconds time) const;

  bool is_on() const { return is_wanted_ && parts_; }

  /// Returns the solver's part. Valid until the next want() or show().
  TargetView target() const;

  /// Returns whether add_layer() adds anything.
  bool has_layer() const { return layer_share() > 0; }

  /// Adds the layer to the vertices, except around triangles that would turn by more than 90
  /// degrees against the scan's with it. Shapes: one per vertex, file units.
  void add_layer(std::span<Vec3d> positions) const;

  /// Returns what add_layer() adds, times `scale`. Without positions it leaves no triangle out.
  std::vector<Vec3f> layer(std::span<const Vec3d> positions, double scale) const;

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
  void set(const Fields& fields, double strength);
  double layer_share() const { return is_on() ? strength_.most() * parts_->filter.crispness : 0; }
  std::vector<float> layer_shares() const;
  std::vector<float> layer_shares(std::span<const Vec3d> positions) const;
  std::vector<uint8_t> find_turned(std::span<const Vec3d> positions,
                                   std::span<const float> shares) const;
  bool stop_turned(std::span<const Vec3d> positions, std::vector<float>& shares) const;

  const std::shared_ptr<const PreparedMesh> prepared_;
  const BackendKind backend_;
  const int threads_;
  bool is_wanted_ = false;
  EdgeStrength strength_;
  std::shared_ptr<const EdgeParts> parts_;  // of perhaps another filter than is wanted
  uint64_t version_ = 0;                    // of the parts
  std::optional<Work> work_;
};

}  // namespace burnish
