#pragma once

#include <memory>
#include <span>
#include <vector>

#include "server/fields/fields.h"
#include "server/solver/solver.h"

namespace burnish {

/// The colours of a scan as a second signal on its surface: the equation of the displacement, with
/// colours in linear light in place of places, and with an α, β and paint of their own. A colour of
/// the scan changes by the solver's result there, so details finer than the grid stay. A solver
/// of its own is made when colours are first edited.
class ColourChannel {
 public:
  ColourChannel(const Multigrid& on, const SolverOptions& options);
  ~ColourChannel();

  /// Says how colours are filtered. Needs: a scan with colours, unless they are kept.
  void want(const Fields& fields);

  /// Solves for them once more, from those of the scan: the result depends on what is wanted alone.
  void start_over();

  /// Returns whether the colours are not yet what is wanted.
  bool is_solving() const { return is_solving_; }

  /// Does one cycle. Fails: as Solver::create() and Solver::status() do.
  Status step();

  /// Returns the change of colour, valid until the next step; empty while colours are kept.
  /// Shapes: one per corner. Units: linear light, 0 to 1.
  std::span<const Vec3f> change() const;

  /// Returns the colours of the vertices. Shapes: one per vertex.
  std::vector<Rgba8> colours() const;

  uint64_t byte_count() const;

 private:
  Status begin();
  void show_to_solver();
  void take_paint(const PaintLayer* paint);
  FieldsView view() const;

  Multigrid on_;
  SolverOptions options_;
  std::unique_ptr<Solver> solver_;
  bool is_kept_ = true;  // no colour changes
  bool is_solving_ = false;
  bool is_metric_new_ = true, is_scale_new_ = true, starts_over_ = false;
  int cycles_ = 0;  // since the last change
  // What is wanted.
  ColourFilter filter_;
  uint64_t paint_version_ = 0;
  std::shared_ptr<const Hold> hold_;
  TransferCurve curve_;
  std::vector<float> follow_, own_;  // per cell, as CellPaint has them
  std::vector<uint8_t> is_painted_;  // likewise
};

}  // namespace burnish
