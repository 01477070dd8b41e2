#include "server/solver/cuda/assembly/device_alpha.h"

#include <cmath>
#include <utility>

#include "server/solver/cuda/assembly/combined_cells.h"

namespace burnish::cuda {

static_assert(AlphaSource::kPointsMax >= kCurvePointsMax);
static_assert(sizeof(HeldLine) == sizeof(LineMass) && HeldLine::kStretch == LineView::kStretch);

static std::vector<OwnAlpha> own_alphas(std::span<const OwnFields> of_cells) {
  std::vector<OwnAlpha> own;
  own.reserve(of_cells.size());
  for (const OwnFields& of : of_cells) own.push_back({of.cell, of.alpha1, of.alpha2});
  return own;
}

// Lines of the same cells are the same lines.
void DeviceAlpha::set_lines(Stream& stream, const LineView& held) {
  std::vector<int32_t> cells;
  for (const LineMass& line : held.lines) cells.push_back(line.cell);
  if (cells == line_cells_) return;
  lines_ = DeviceArray<HeldLine>::copy_of(stream, held.lines);
  first_line_ = {stream, held.first};
  stream.synchronize();
  line_cells_ = std::move(cells);
}

void DeviceAlpha::set(Stream& stream, const MetricView& metric) {
  if (metric.own.size() > own_.size()) own_ = {stream, metric.own.size()};
  const std::vector<OwnAlpha> own = own_alphas(metric.own);
  upload(stream, own_.data(), std::span<const OwnAlpha>(own));
  AlphaSource source{};
  source.own = own_.data();
  source.own_count = static_cast<int32_t>(own.size());
  set_lines(stream, metric.held);
  source.lines = lines_.data();
  source.first_line = line_cells_.empty() ? nullptr : first_line_.data();
  for (const TransferCurve::Point& point : metric.curve->points()) {
    source.kappa[source.point_count] = point.kappa;
    source.log_alpha[source.point_count++] = std::log(point.alpha);
  }
  tell_alpha(stream, source, source_.data());
}

}  // namespace burnish::cuda
