#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/mesh/textures/texel_change.h"
#include "server/fields/fields.h"
#include "server/session/colour_change.h"
#include "server/session/mesh_signal.h"
#include "server/solver/solver.h"

namespace burnish {

/// The colours of a scan as a second signal on its surface: the equation of the displacement, with
/// colours in linear light in place of places, and with an α, β and paint of their own. A colour of
/// the scan changes by the solver's result there. A solver of its own is made when colours are
/// first edited. Colours know details finer than a cell, so once the grid is solved a few steps on
/// the scan's own triangles follow. The texture filter takes no solve, only a fit. Its gain may be
/// painted.
class ColourChannel {
 public:
  ColourChannel(const Multigrid& on, const SolverOptions& options);
  ~ColourChannel();

  /// Says how colours are filtered. Needs: a scan with colours, unless they are kept.
  void want(const Fields& fields);

  /// Solves for them once more, from those of the scan: the result depends on what is wanted alone.
  void start_over();

  /// Returns whether the colours are not yet what is wanted.
  bool is_solving() const { return is_solving_ || lacks_fit() || lacks_light(); }

  /// Does one cycle, or a fit. Fails: as Solver::create() and Solver::status() do.
  Status step();

  /// Returns the change of colour anywhere on the surface, valid until the next step. Units: linear
  /// light, 0 to 1.
  ColourChange change() const;

  /// Returns the colours of the vertices. Shapes: one per vertex.
  std::vector<Rgba8> colours() const;
  /// Returns what the texels at the vertices do. Shapes: one per vertex; empty: none changes.
  std::vector<TexelChange> texels() const;
  uint64_t byte_count() const;

 private:
  bool changes_texture() const { return texture_.changes_colours() || !gains_.empty(); }
  bool lacks_fit() const { return changes_texture() && fitted_.empty(); }
  bool lacks_light() const { return texture_.remove_light > 0 && light_.empty(); }
  void fit();
  void want_filtered(const Fields& fields);
  void want_texture(const Fields& fields);
  template <typename Use>
  void each_change(const Use& use) const;
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
  std::vector<CornerNumber> light_;
  bool is_kept_ = true;  // by the filter of colours
  bool is_solving_ = false;
  bool is_metric_new_ = true, is_scale_new_ = true, starts_over_ = false;
  int cycles_ = 0;      // on the grid, since the last change
  int mesh_steps_ = 0;  // likewise
  // The wanted filter.
  ColourFilter filter_;
  TextureFilter texture_;
  std::vector<float> gains_;  // per cell; empty: the gain is not painted
  uint64_t paint_version_ = 0, gains_version_ = 0;
  std::shared_ptr<const Hold> hold_;
  TransferCurve curve_;
  std::vector<float> follow_, own_;  // per cell, as CellPaint has them
  std::vector<uint8_t> is_painted_;  // likewise
};

}  // namespace burnish
