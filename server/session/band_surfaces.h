#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "server/fields/fields.h"
#include "server/solver/solver.h"

namespace burnish {

/// The surfaces between the bands of an equaliser: the scan smoothed at the α of each band's size,
/// β = 0. They depend on the sizes and on what is held, not on gains, and are solved once. A solver
/// of their own lives while one is missing.
class BandSurfaces {
 public:
  BandSurfaces(const Multigrid& on, const SolverOptions& options);
  ~BandSurfaces();

  /// Takes which surfaces are wanted, and what is held. Those that are there already stay.
  void want(const Fields& fields);

  /// Solves for all of them once more: they depend on what is wanted alone.
  void start_over();

  /// Returns whether a wanted surface is missing.
  bool is_solving() const { return known_count() < wanted_.size(); }

  /// Does one cycle for the first missing surface. Returns whether it is there now. Fails: as
  /// Solver::create() and Solver::status() do.
  Result<bool> step();

  /// Returns how many surfaces are there, from the finest band on without a gap.
  size_t known_count() const;

  /// Returns the displacement of the surface behind a band. Shapes: `band` from 1 to known_count();
  /// one per corner. Units: cells.
  std::span<const Vec3f> behind(size_t band) const;

  uint64_t byte_count() const;

 private:
  struct Surface {
    double alpha;
    std::vector<Vec3f> displacement;
  };

  const Surface* find(double alpha) const;
  Status begin(double alpha);

  Multigrid on_;
  SolverOptions options_;
  std::vector<double> wanted_;  // α of each band, falling
  std::shared_ptr<const Hold> hold_;
  std::shared_ptr<const HeldRims> rims_;
  std::vector<Surface> surfaces_;
  std::unique_ptr<Solver> solver_;  // while a surface is missing
  std::optional<double> solved_;    // α that the solver works on
  int cycles_ = 0;                  // for it
};

}  // namespace burnish
