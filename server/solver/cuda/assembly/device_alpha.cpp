#include "server/solver/cuda/assembly/device_alpha.h"

#include <cmath>

#include "server/solver/cuda/assembly/combined_cells.h"

namespace burnish::cuda {

static_assert(AlphaSource::kPointsMax >= kCurvePointsMax);

static std::vector<OwnAlpha> own_alphas(std::span<const OwnFields> of_cells) {
  std::vector<OwnAlpha> own;
  own.reserve(of_cells.size());
  for (const OwnFields& of : of_cells) own.push_back({of.cell, of.alpha1, of.alpha2});
  return own;
}

void DeviceAlpha::set(Stream& stream, const MetricView& metric) {
  if (metric.own.size() > own_.size()) own_ = {stream, metric.own.size()};
  const std::vector<OwnAlpha> own = own_alphas(metric.own);
  upload(stream, own_.data(), std::span<const OwnAlpha>(own));
  AlphaSource source{};
  source.own = own_.data();
  source.own_count = static_cast<int32_t>(own.size());
  for (const TransferCurve::Point& point : metric.curve->points()) {
    source.kappa[source.point_count] = point.kappa;
    source.log_alpha[source.point_count++] = std::log(point.alpha);
  }
  tell_alpha(stream, source, source_.data());
}

}  // namespace burnish::cuda
