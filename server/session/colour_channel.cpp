#include "server/session/colour_channel.h"

#include <algorithm>

#include "common/evaluation/evaluation.h"
#include "common/mesh/srgb.h"
#include "server/session/fit_signal.h"
#include "server/session/second_solver.h"

namespace burnish {

// A fifth of a byte of sRGB is 6e-5 of linear light where it is darkest.
static constexpr double kColourDistanceMax = 3e-5;
static constexpr int kColourCyclesMax = 500;
// The grid solves all that is larger than some cells. After so many steps the rest is less than
// the rounding of a byte.
static constexpr int kMeshStepsMax = 32;

ColourChannel::ColourChannel(const Multigrid& on, const SolverOptions& options)
    : on_(on), options_(options), curve_(filter_.alpha) {}
ColourChannel::~ColourChannel() = default;

void ColourChannel::want(const Fields& fields) {
  if (!on_.prepared->colours.empty()) want_texture(fields);
  want_filtered(fields);
}

// Paint covers the slider.
void ColourChannel::want_texture(const Fields& fields) {
  const uint64_t version = fields.paint_versions().texture;
  const bool is_old = version != gains_version_ || fields.texture().gain != texture_.gain;
  texture_ = fields.texture();
  gains_version_ = version;
  const PaintLayer* paint = fields.texture_paint();
  if (paint == nullptr) gains_.clear();
  if (paint == nullptr || !is_old) return;
  gains_.resize(on_.prepared->cells.size());
  const auto slider = static_cast<float>(texture_.gain);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < gains_.size(); ++c)
    gains_[c] = slider + paint->weight[c] * (paint->value[c] - slider);
}

void ColourChannel::want_filtered(const Fields& fields) {
  const uint64_t version = fields.paint_versions().colour;
  const bool is_paint_new = version != paint_version_ || fields.colour_hold() != hold_;
  if (fields.colour() == filter_ && !is_paint_new) return;
  is_metric_new_ |= fields.colour().alpha != filter_.alpha;
  is_scale_new_ = true;
  filter_ = fields.colour();
  paint_version_ = version;
  hold_ = fields.colour_hold();
  is_kept_ = on_.prepared->colours.empty() || (filter_.beta == 1 && !fields.colour_paint());
  if (is_paint_new) take_paint(fields.colour_paint());
  is_solving_ = !is_kept_;
  begin_on_grid();
}

// The last share stays meanwhile: details that come back while a slider moves would flicker.
void ColourChannel::begin_on_grid() {
  is_on_mesh_ = false;
  cycles_ = 0;
}

void ColourChannel::start_over() {
  is_solving_ = starts_over_ = !is_kept_;
  begin_on_grid();
}

void ColourChannel::take_paint(const PaintLayer* paint) {
  const size_t cells = on_.prepared->cells.size();
  follow_.assign(cells, 1);
  own_.assign(cells, 0);
  is_painted_.assign((cells + CellPaint::kStretch - 1) / CellPaint::kStretch, paint || hold_);
#pragma omp parallel for schedule(static) if (paint || hold_)
  for (size_t c = 0; c < cells; ++c) {
    const float left = hold_ ? 1 - hold_->weight[c] : 1;
    const float weight = paint ? paint->weight[c] : 0;
    follow_[c] = left * (1 - weight);
    own_[c] = weight > 0 ? left * weight * (paint->value[c] - 1) : 0;
  }
}

FieldsView ColourChannel::view() const {
  return {{&curve_, {}}, {}, filter_.beta, {follow_, own_, is_painted_}};
}

static std::vector<Vec3f> linear_colours(std::span<const Rgba8> colours) {
  std::vector<Vec3f> linear(colours.size());
  for (size_t v = 0; v < colours.size(); ++v) linear[v] = linear_colour(colours[v]);
  return linear;
}

void ColourChannel::fit() {
  fitted_ = fit_signal(on_, linear_colours(on_.prepared->colours)).corners;
}

Status ColourChannel::begin() {
  ASSIGN_OR_RETURN(solver_, make_second_solver(on_, options_));
  if (fitted_.empty()) fit();
  solver_->set_signal(fitted_);
  mesh_ = std::make_unique<MeshSignal>(*on_.prepared, linear_colours(on_.prepared->colours));
  if (follow_.empty()) take_paint(nullptr);
  return Status::ok();
}

Status ColourChannel::step() {
  if (lacks_fit() || lacks_light()) {
    if (lacks_fit()) fit();
    if (lacks_light()) light_ = find_baked_light(on_, fitted_);
    return Status::ok();
  }
  if (!solver_) RETURN_IF_ERROR(begin());
  if (!is_on_mesh_) return step_on_grid();
  step_on_mesh();
  return Status::ok();
}

Status ColourChannel::step_on_grid() {
  show_to_solver();
  const StepReport report = solver_->step();
  RETURN_IF_ERROR(solver_->status());
  const PreparedMesh& prepared = *on_.prepared;
  const double distance =
      report.distance * prepared.statistics.diagonal() / prepared.frame.cell_size;
  if (distance > kColourDistanceMax && ++cycles_ < kColourCyclesMax) return Status::ok();
  mesh_->begin(filter_.alpha, beta_above_one(), solver_->vertex_displacement());
  is_on_mesh_ = true;
  mesh_steps_ = 0;
  return Status::ok();
}

void ColourChannel::step_on_mesh() {
  const float moved = mesh_->step();
  is_solving_ = moved > kColourDistanceMax && ++mesh_steps_ < kMeshStepsMax;
  if (!is_solving_) find_share(mesh_->change());
}

// Least squares: the vertices of pictures are not those of the scan, but details are alike.
void ColourChannel::find_share(std::span<const Vec3f> change) {
  const PreparedMesh& prepared = *on_.prepared;
  const SparseGrid& grid = on_.hierarchy->at(on_.hierarchy->finest).grid;
  const std::span<const Vec3f> on_grid = solver_->vertex_displacement();
  share_.assign(prepared.cells.size(), 0);
  std::vector<float> squares(prepared.cells.size(), 0);
  for (size_t v = 0; v < change.size(); ++v) {
    const EvaluationPoint& at = prepared.evaluation[v];
    if (at.cell == kNone) continue;
    const Vec3f finer =
        linear_colour(prepared.colours[v]) - evaluate(grid, at, std::span<const Vec3f>(fitted_));
    share_[at.cell] += finer.dot(change[v] - on_grid[v]);
    squares[at.cell] += finer.squaredNorm();
  }
  constexpr float kNothing = 1e-9F;  // far below the rounding of bytes
  for (size_t cell = 0; cell < share_.size(); ++cell)
    share_[cell] = squares[cell] > kNothing ? share_[cell] / squares[cell] : 0;
}

std::vector<float> ColourChannel::beta_above_one() const {
  std::vector<float> above(follow_.size());
  const auto slider = static_cast<float>(filter_.beta - 1);
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < above.size(); ++cell)
    above[cell] = follow_[cell] * slider + own_[cell];
  return above;
}

void ColourChannel::show_to_solver() {
  curve_ = TransferCurve(filter_.alpha);
  if (starts_over_)
    solver_->start_over(view());
  else if (is_metric_new_)
    solver_->set_metric(view());
  else if (is_scale_new_)
    solver_->set_gradient_scale(view());
  is_metric_new_ = is_scale_new_ = starts_over_ = false;
}

ColourChange ColourChannel::change() const {
  ColourChange change;
  if (!is_kept_ && solver_) change = {solver_->displacement(), fitted_, share_};
  if (!changes_texture() || lacks_fit() || lacks_light()) return change;
  change.fitted = fitted_;
  change.texture = {texture_, texture_.remove_light > 0 ? light_ : std::span<const CornerNumber>(),
                    hold_ ? hold_->weight : std::span<const float>(), gains_};
  return change;
}

/// Calls use(vertex, change) from several threads.
template <typename Use>
void ColourChannel::each_change(const Use& use) const {
  const PreparedMesh& prepared = *on_.prepared;
  const SparseGrid& grid = on_.hierarchy->at(on_.hierarchy->finest).grid;
  const ColourChange change = this->change();
  std::vector<Vec3f> filtered(prepared.vertices.size(), Vec3f::Zero());
  if (!change.on_grid.empty() && is_on_mesh_) filtered = mesh_->change();
  if (!change.on_grid.empty() && !is_on_mesh_)
    std::ranges::copy(solver_->vertex_displacement(), filtered.begin());
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < filtered.size(); ++v)
    use(v, with_texture(change, grid, prepared.evaluation[v], prepared.colours[v], filtered[v]));
}

std::vector<Rgba8> ColourChannel::colours() const {
  const std::span<const Rgba8> before = on_.prepared->colours;
  std::vector<Rgba8> colours(before.begin(), before.end());
  if (!change().is_there()) return colours;
  each_change([&](size_t v, const PointChange& change) {
    colours[v] = changed_colour(before[v], change.colour);
  });
  return colours;
}

std::vector<TexelChange> ColourChannel::texels() const {
  const std::span<const Rgba8> before = on_.prepared->colours;
  if (!change().is_there()) return {};
  std::vector<TexelChange> texels(before.size());
  each_change([&](size_t v, const PointChange& change) {
    texels[v] = texel_change(before[v], change.colour, change.gain);
  });
  return texels;
}

uint64_t ColourChannel::byte_count() const {
  return (solver_ ? solver_->byte_count() : 0) + (mesh_ ? mesh_->byte_count() : 0) +
         fitted_.size() * sizeof(Vec3f) + light_.size() * sizeof(CornerNumber) +
         (follow_.size() + own_.size() + share_.size() + gains_.size()) * sizeof(float);
}

}  // namespace burnish
