// The part of Fields for paint.

#include <algorithm>
#include <atomic>
#include <limits>

#include "common/grid/morton.h"
#include "server/fields/cell_index.h"
#include "server/fields/cells_in_box.h"
#include "server/fields/fields.h"

namespace burnish {

// With fewer cells times dabs, one thread is done before others wake.
static constexpr size_t kPaintParallelMin = 1 << 13;

std::vector<int64_t> Fields::cells_near(const Brush& brush, std::span<const Vec3d> centres) const {
  return cells_in(box_of(centres, brush.radius), prepared_);
}

/// Returns the fraction of earlier paint at `place` that shows through the dabs.
static double left_by(const Brush& brush, std::span<const Vec3d> centres, const Vec3d& place) {
  double left = 1;
  for (const Vec3d& centre : centres) {
    const double distance = (place - centre).norm() / brush.radius;
    left *= 1 - brush.strength * fall_off_weight(brush.fall_off, distance);
    if (left == 0) break;
  }
  return left;
}

PaintLayer& Fields::make_layer(size_t number) {
  std::optional<PaintLayer>& layer = paint_[number];
  if (!layer) layer.emplace(prepared_.cells.size());
  return *layer;
}

void Fields::paint(const Brush& brush, std::span<const Vec3d> centres,
                   std::span<const int64_t> cells) {
  const size_t number = layer_of(brush);
  PaintLayer& layer = make_layer(number);
  const AxisBox box = box_of(centres, brush.radius);
  for (const int64_t c : cells) may_have_paint_[c / kStretch] = blend_is_old_[c / kStretch] = 1;
  [[maybe_unused]] const bool is_long = cells.size() * centres.size() >= kPaintParallelMin;
#pragma omp parallel for schedule(dynamic, 256) if (is_long)
  for (size_t i = 0; i < cells.size(); ++i) {
    const int64_t c = cells[i];
    const Vec3i cell = morton_point(prepared_.cells[c]);
    const Vec3d middle = prepared_.frame.to_file(cell.cast<double>() + Vec3d::Constant(0.5));
    if (!box.contains(middle)) continue;
    blend(brush, c, left_by(brush, centres, middle), layer);
  }
  mark_painted(number);
}

void Fields::blend(const Brush& brush, int64_t cell, double left, PaintLayer& layer) {
  if (left == 1) return;
  layer.blend(cell, left, brush.beta);
  if (brush.curve > 0) cover_other_curves(cell, left, layer);
}

void Fields::paint(const Brush& brush, std::span<const Vec3d> centres) {
  if (!brush.connected) return paint(brush, centres, cells_near(brush, centres));
  ConnectedDabs dabs = connected_dabs(brush, centres);
  dabs.advance(std::numeric_limits<size_t>::max());
  paint(brush, dabs);
}

ConnectedDabs Fields::connected_dabs(const Brush& brush, std::span<const Vec3d> centres) const {
  return {prepared_, brush, {centres.begin(), centres.end()}, cells_near(brush, centres)};
}

void Fields::paint(const Brush& brush, const ConnectedDabs& dabs,
                   const std::function<bool(int64_t)>& is_spared) {
  const size_t number = layer_of(brush);
  PaintLayer& layer = make_layer(number);
  for (size_t i = 0; i < dabs.cells().size(); ++i) {
    const int64_t c = dabs.cells()[i];
    if (dabs.left()[i] == 1 || (is_spared && is_spared(c))) continue;
    may_have_paint_[c / kStretch] = blend_is_old_[c / kStretch] = 1;
    blend(brush, c, dabs.left()[i], layer);
  }
  mark_painted(number);
}

void Fields::paint(const SetCellFields& change, const std::function<bool(int64_t)>& is_spared) {
  const size_t number = layer_of(change.target).value();
  PaintLayer& layer = make_layer(number);
  for (const SetCellFields::Cell& cell : change.cells) {
    const int32_t c = index_of_cell(prepared_, cell.cell).value();
    if (is_spared && is_spared(c)) continue;
    may_have_paint_[c / kStretch] = 1;
    layer.blend(c, 0, cell.beta);
  }
  mark_painted(number);
}

/// Lets a painted curve cover those that rule a cell so far.
void Fields::cover_other_curves(size_t cell, double left, const PaintLayer& painted) {
  for (size_t number = kFirstCurveLayer; number < kColourLayer; ++number)
    if (paint_[number] && &*paint_[number] != &painted)
      paint_[number]->weight[cell] *= static_cast<float>(left);
}

void Fields::mark_painted(size_t layer) {
  static std::atomic<uint64_t> versions{0};
  const uint64_t version = ++versions;  // no two fields with different paint have the same
  if (layer == kBetaLayer) {
    beta_is_old_ = true;
    versions_.beta = version;
  } else if (layer < kFirstCurveLayer) {
    versions_.gains = version;
  } else if (layer < kColourLayer) {
    alphas_are_old_ = true;
    versions_.curves = version;
  } else {
    (layer == kColourLayer  ? versions_.colour
     : layer == kEdgesLayer ? versions_.edges
                            : versions_.texture) = version;
  }
}

void Fields::append_painted(size_t number, PaintedCells& painted) const {
  const PaintLayer& layer = *paint_[number];
  for (size_t stretch = 0; stretch < may_have_paint_.size(); ++stretch) {
    if (!may_have_paint_[stretch]) continue;
    const size_t end = std::min((stretch + 1) * kStretch, layer.weight.size());
    for (size_t c = stretch * kStretch; c < end; ++c) {
      if (layer.weight[c] == 0 && layer.value[c] == 0) continue;
      painted.cells.push_back(static_cast<int32_t>(c));
      painted.value.push_back(layer.value[c]);
      painted.weight.push_back(layer.weight[c]);
      painted.layer.push_back(static_cast<uint8_t>(number));
    }
  }
}

PaintedCells Fields::painted() const {
  PaintedCells painted;
  for (size_t number = 0; number < kPaintLayers; ++number)
    if (paint_[number]) append_painted(number, painted);
  if (painted.layer.empty() || painted.layer.back() == kBetaLayer) painted.layer.clear();
  return painted;
}

void Fields::set_painted(const PaintedCells& painted) {
  for (size_t number = 0; number < kPaintLayers; ++number) {
    if (!paint_[number]) continue;
    paint_[number].reset();
    mark_painted(number);
  }
  make_layer(kBetaLayer);
  std::fill(follow_.begin(), follow_.end(), 1.0f);
  std::fill(own_.begin(), own_.end(), 0.0f);
  std::fill(may_have_paint_.begin(), may_have_paint_.end(), uint8_t{0});
  for (const OwnFields& own : overrides_) may_have_paint_[own.cell / kStretch] = 1;
  mark_held();
  make_blends_old();
  for (size_t i = 0; i < painted.cells.size(); ++i) {
    const int32_t cell = painted.cells[i];
    PaintLayer& layer = make_layer(painted.layer.empty() ? kBetaLayer : painted.layer[i]);
    layer.value[cell] = painted.value[i];
    layer.weight[cell] = painted.weight[i];
    may_have_paint_[cell / kStretch] = 1;
  }
  for (size_t number = 0; number < kPaintLayers; ++number)
    if (paint_[number]) mark_painted(number);
}

int Fields::ruling_curve(size_t cell) const {
  int ruling = 0;
  float own = 1, most = 0;
  for (size_t i = 0; i < palette().curves.size(); ++i) {
    const auto& layer = paint_[kFirstCurveLayer + i];
    if (!layer) continue;
    const float weight = layer->weight[cell];
    own -= weight;
    if (weight <= most) continue;
    most = weight;
    ruling = static_cast<int>(i) + 1;
  }
  return most > own ? ruling : 0;
}

bool Fields::has_painted_curves() const {
  return std::any_of(paint_.begin() + kFirstCurveLayer, paint_.begin() + kColourLayer,
                     [](const auto& layer) { return layer.has_value(); });
}

}  // namespace burnish
