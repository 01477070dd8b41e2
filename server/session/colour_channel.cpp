#include "server/session/colour_channel.h"

#include "common/mesh/srgb.h"
#include "server/session/fit_signal.h"
#include "server/session/second_solver.h"

namespace burnish {

// A fifth of a byte of sRGB is 6e-5 of linear light where it is darkest.
static constexpr double kColourDistanceMax = 3e-5;
static constexpr int kColourCyclesMax = 500;

ColourChannel::ColourChannel(const Multigrid& on, const SolverOptions& options)
    : on_(on), options_(options), curve_(filter_.alpha) {}
ColourChannel::~ColourChannel() = default;

void ColourChannel::want(const Fields& fields) {
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
  cycles_ = 0;
}

void ColourChannel::start_over() {
  is_solving_ = starts_over_ = !is_kept_;
  cycles_ = 0;
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
  for (size_t v = 0; v < colours.size(); ++v)
    for (int channel = 0; channel < 3; ++channel)
      linear[v][channel] = linear_of_srgb(colours[v][channel]);
  return linear;
}

Status ColourChannel::begin() {
  ASSIGN_OR_RETURN(solver_, make_second_solver(on_, options_));
  solver_->set_signal(fit_signal(on_, linear_colours(on_.prepared->colours)));
  if (follow_.empty()) take_paint(nullptr);
  return Status::ok();
}

Status ColourChannel::step() {
  if (!solver_) RETURN_IF_ERROR(begin());
  show_to_solver();
  const StepReport report = solver_->step();
  RETURN_IF_ERROR(solver_->status());
  const PreparedMesh& prepared = *on_.prepared;
  const double distance =
      report.distance * prepared.statistics.diagonal() / prepared.frame.cell_size;
  is_solving_ = distance > kColourDistanceMax && ++cycles_ < kColourCyclesMax;
  return Status::ok();
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

std::span<const Vec3f> ColourChannel::change() const {
  if (is_kept_ || !solver_) return {};
  return solver_->displacement();
}

std::vector<Rgba8> ColourChannel::colours() const {
  const PreparedMesh& prepared = *on_.prepared;
  std::vector<Rgba8> colours(prepared.colours.begin(), prepared.colours.end());
  if (is_kept_ || !solver_) return colours;
  const std::span<const Vec3f> change = solver_->vertex_displacement();
#pragma omp parallel for schedule(static)
  for (size_t v = 0; v < colours.size(); ++v) colours[v] = changed_colour(colours[v], change[v]);
  return colours;
}

uint64_t ColourChannel::byte_count() const {
  return (solver_ ? solver_->byte_count() : 0) + (follow_.size() + own_.size()) * sizeof(float);
}

}  // namespace burnish
