#pragma once

#include <memory>
#include <span>
#include <vector>

#include "server/fields/fields.h"
#include "server/session/mesh_signal.h"
#include "server/solver/solver.h"

namespace burnish {

/// A change of colour on the grid and what it leaves of details that are finer than a cell. At a
/// point of colour f the change is that of the grid, plus the cell's share times f less the fitted
/// colour.
struct ColourChange {
  std::span<const Vec3f> on_grid;  ///< per corner; empty: no colour changes
  std::span<const Vec3f> fitted;   ///< per corner: the grid's nearest to the scan's colours
  std::span<const float> share;    ///< per cell, of the last solve on triangles; empty before it
};

/// The colours of a scan as a second signal on its surface: the equation of the displacement, with
/// colours in linear light in place of places, and with an α, β and paint of their own. A colour of
/// the scan changes by the solver's result there. A solver of its own is made when colours are
/// first edited. Colours know details finer than a cell, so once the grid is solved a few steps on
/// the scan's own triangles follow.
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

  /// Returns the change of colour anywhere on the surface, valid until the next step. Units: linear
  /// light, 0 to 1.
  ColourChange change() const;

  /// Returns the colours of the vertices. Shapes: one per vertex.
  std::vector<Rgba8> colours() const;

  uint64_t byte_count() const;

 private:
  Status begin();
  void begin_on_grid();
  Status step_on_grid();
  void step_on_mesh();
  void find_share(std::span<const Vec3f> change);
  std::vector<float> beta_above_one() const;
  void show_to_solver();
  void take_paint(const PaintLayer* paint);
  FieldsView view() const;

  Multigrid on_;
  SolverOptions options_;
  std::unique_ptr<Solver> solver_;
  std::unique_ptr<MeshSignal> mesh_;
  bool is_on_mesh_ = false;  // the grid is solved
  std::vector<Vec3f> fitted_;
  std::vector<float> share_;
  bool is_kept_ = true;  // no colour changes
  bool is_solving_ = false;
  bool is_metric_new_ = true, is_scale_new_ = true, starts_over_ = false;
  int cycles_ = 0;      // on the grid, since the last change
  int mesh_steps_ = 0;  // likewise
  // What is wanted.
  ColourFilter filter_;
  uint64_t paint_version_ = 0;
  std::shared_ptr<const Hold> hold_;
  TransferCurve curve_;
  std::vector<float> follow_, own_;  // per cell, as CellPaint has them
  std::vector<uint8_t> is_painted_;  // likewise
};

}  // namespace burnish
