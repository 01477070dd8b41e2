#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/edit/edit.h"
#include "server/fields/alphas.h"
#include "server/fields/connected_dabs.h"
#include "server/fields/fields_view.h"
#include "server/fields/hold.h"
#include "server/fields/paint_layer.h"
#include "server/fields/rims.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// The metric and β per cell (section 4.3), and their sources: slider, paint, curve, palette,
/// overrides. Setting a source is cheap. The next view() computes the cells, once for all changes.
/// It also keeps what is not for the solver: the equaliser, the paint of its gains, what filters
/// the colours, and where edges are kept. Shapes: one entry per cell of the finest depth. Units: α
/// in user units.
class Fields {
 public:
  /// Begins with the defaults everywhere: α = 50, β = 1.
  explicit Fields(const PreparedMesh& prepared);

  /// A painted curve that the palette lacks rules nothing.
  void set(const Settings& settings);
  const Settings& settings() const { return settings_; }
  void set_transfer_curve(const TransferCurve& curve);
  void set_gradient_scale(double beta);
  void set_palette(const Palette& palette);
  void paint(const Stroke& stroke) { paint(stroke.brush, dab_centres(stroke)); }
  /// Paints some dabs of a stroke. Shapes: at least one centre, file units.
  void paint(const Brush& brush, std::span<const Vec3d> centres);
  /// Does the same for some of the cells near them, to paint in pieces. Needs: a brush that paints
  /// through walls.
  void paint(const Brush& brush, std::span<const Vec3d> centres, std::span<const int64_t> cells);
  /// Returns the dabs of a connected brush, to advance in pieces.
  ConnectedDabs connected_dabs(const Brush& brush, std::span<const Vec3d> centres) const;
  /// Paints dabs that are done. Leaves out the cells for which `is_spared` is true.
  void paint(const Brush& brush, const ConnectedDabs& dabs,
             const std::function<bool(int64_t)>& is_spared = {});
  /// Paints the strength of kept edges or the texture gain in single cells, over earlier paint.
  /// Leaves out the cells for which `is_spared` is true. Needs: a change of kEdges or kTexture
  /// whose cells are active.
  void paint(const SetCellFields& change, const std::function<bool(int64_t)>& is_spared = {});
  /// Returns the cells that these dabs may reach, and few others; rising.
  std::vector<int64_t> cells_near(const Brush& brush, std::span<const Vec3d> centres) const;
  /// Fails: invalid_argument that names the first cell that is not active; then nothing is changed.
  Status override_cells(const SetCellFields& change);
  /// Returns the status that override_cells() would return.
  Status check(const SetCellFields& change) const;
  /// Also refuses more cells than there are, and a cell that is set twice. For changes that are
  /// new. Fails: invalid_argument that names the count or the first such cell.
  Status check_new(const SetCellFields& change) const;
  /// Returns whether a dab of the stroke reaches a cell of this kind, in part or whole. May return
  /// true for a long connected stroke that reaches none.
  bool touches(const Stroke& stroke, const std::function<bool(int64_t)>& is_asked) const;
  /// Fails: invalid_argument if no dab of the stroke reaches a cell.
  Status check_new(const Stroke& stroke) const;
  void clear_overrides();
  /// Leads β to 1 and raises α in held cells, over all other sources. Null: nothing is held.
  void set_hold(std::shared_ptr<const Hold> hold);
  const std::shared_ptr<const Hold>& hold() const { return hold_; }
  /// Holds the lines of rims. Fields beside them stay as they are. Null: no rim is held.
  void set_rims(std::shared_ptr<const HeldRims> rims) { rims_ = std::move(rims); }
  const std::shared_ptr<const HeldRims>& rims() const { return rims_; }

  PaintedCells painted() const;
  /// Replaces all paint. Needs: paint of the same prepared mesh.
  void set_painted(const PaintedCells& painted);

  FieldsView view() const;
  CellAlphas alphas() const;  ///< computed from view().metric
  const TransferCurve& transfer_curve() const { return settings_.curve; }
  const Palette& palette() const { return settings_.palette; }
  bool has_painted_curves() const;
  /// Returns the number of the palette's curve that rules most of a cell, 0 for the own curve.
  int ruling_curve(size_t cell) const;
  const Equaliser& equaliser() const { return settings_.equaliser; }
  /// Returns the paint of a band's gain, null without. Shapes: `band` from 1.
  const PaintLayer* gain_paint(size_t band) const { return layer(kFirstBandLayer + band - 1); }
  const ColourFilter& colour() const { return settings_.colour; }
  const TextureFilter& texture() const { return settings_.texture; }
  /// Returns the paint of the colours' β, null without.
  const PaintLayer* colour_paint() const { return layer(kColourLayer); }
  /// Returns the paint of the strength of kept edges, null without.
  const PaintLayer* edge_paint() const { return layer(kEdgesLayer); }
  /// Returns the paint of the texture gain, null without.
  const PaintLayer* texture_paint() const { return layer(kTextureLayer); }
  /// Returns whether edges are kept, everywhere or where it is painted.
  bool keeps_edges() const { return settings_.edges.is_on() || edge_paint(); }
  /// Sets where colours are kept: in the protected region, not at rims. Null: nowhere.
  void set_colour_hold(std::shared_ptr<const Hold> hold) { colour_hold_ = std::move(hold); }
  const std::shared_ptr<const Hold>& colour_hold() const { return colour_hold_; }
  /// Returns how far each cell is edited, by β or by the gain of a band: 0 to 1. Kept edges and the
  /// texture gain do not count.
  std::vector<float> edited() const;
  /// Says what paint has changed: equal versions have equal paint, in copies too.
  struct PaintVersions {
    uint64_t beta = 0, gains = 0, curves = 0, colour = 0, edges = 0, texture = 0;
  };
  const PaintVersions& paint_versions() const { return versions_; }
  double gradient_scale() const { return settings_.beta; }
  uint64_t byte_count() const;

 private:
  struct PaintedCurves;
  class CurveBlend;

  const PaintLayer* layer(size_t number) const {
    return paint_[number] ? &*paint_[number] : nullptr;
  }
  void update_beta() const;
  void update_beta(size_t stretch) const;
  PaintLayer& make_layer(size_t number);
  void cover_other_curves(size_t cell, double left, const PaintLayer& painted);
  void blend(const Brush& brush, int64_t cell, double left, PaintLayer& layer);
  bool ball_touches(const Stroke& stroke, const std::function<bool(int64_t)>& is_asked) const;
  void mark_painted(size_t layer);
  void append_painted(size_t number, PaintedCells& painted) const;
  void mark_held();
  void hold_beta() const;
  void update_blended_own() const;
  std::vector<std::vector<OwnFields>> blend_stretches(const std::vector<size_t>& stretches) const;
  void blend_stretch(const PaintedCurves& curves, size_t stretch,
                     std::vector<OwnFields>& blended) const;
  void make_blends_old();

  const PreparedMesh& prepared_;  // must outlive the fields
  Settings settings_;
  std::array<std::optional<PaintLayer>, kPaintLayers> paint_;  // that of β is always there
  PaintVersions versions_;
  // Per kStretch cells, so that painted() need not look at all of them: it is called after many
  // strokes. Cells of overrides count as painted.
  static constexpr size_t kStretch = CellPaint::kStretch;
  std::vector<uint8_t> may_have_paint_;
  std::vector<OwnFields> overrides_;  // by rising cell, each once
  std::shared_ptr<const Hold> hold_, colour_hold_;
  std::shared_ptr<const HeldRims> rims_;

  // The result of slider, paint and overrides at the last view().
  mutable std::vector<float> beta_, follow_, own_;
  mutable bool beta_is_old_ = false;
  // The overrides, painted curves and the hold on top, where there is one of these.
  mutable std::vector<OwnFields> blended_own_;
  mutable bool alphas_are_old_ = false;
  mutable std::vector<uint8_t> blend_is_old_;  // per kStretch cells: their blended_own_
};

}  // namespace burnish
