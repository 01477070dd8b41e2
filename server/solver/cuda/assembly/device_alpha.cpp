#include "server/solver/cuda/assembly/device_alpha.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "server/solver/cuda/assembly/combined_cells.h"

namespace burnish::cuda {

static_assert(AlphaSource::kPointsMax >= kCurvePointsMax);
static_assert(sizeof(HeldLine) == sizeof(LineMass) && HeldLine::kStretch == LineView::kStretch);

// Visits both lists in step. A cell that leaves the list, or comes to it, may keep its α by chance.
void DeviceAlpha::find_changed(const MetricView& metric) {
  follows_last_ = curve_ && *curve_ == *metric.curve;
  curve_ = *metric.curve;
  changed_.clear();
  if (!follows_last_) return;
  const OwnAlpha* before = own_of_host_.data();
  const OwnAlpha* const end = before + own_count_;
  for (const OwnFields& now : metric.own) {
    for (; before != end && before->cell < now.cell; ++before) changed_.push_back(before->cell);
    const bool was_own = before != end && before->cell == now.cell;
    if (!was_own || before->alpha1 != now.alpha1 || before->alpha2 != now.alpha2)
      changed_.push_back(now.cell);
    if (was_own) ++before;
  }
  for (; before != end; ++before) changed_.push_back(before->cell);
  add_changed_lines(metric.held.lines);
}

// Lines of the same cells are the same lines.
void DeviceAlpha::add_changed_lines(std::span<const LineMass> lines) {
  std::vector<int32_t> now, moved, all;
  for (const LineMass& line : lines) now.push_back(line.cell);
  std::ranges::set_symmetric_difference(line_cells_, now, std::back_inserter(moved));
  if (moved.empty()) return;
  std::ranges::set_union(changed_, moved, std::back_inserter(all));
  changed_ = std::move(all);
}

// Memory grows by halves, so that most dabs of a stroke take none.
void DeviceAlpha::set_own(Stream& stream, std::span<const OwnFields> of_cells) {
  if (of_cells.size() > own_.size()) {
    const size_t room = of_cells.size() + of_cells.size() / 2;
    own_ = {stream, room};
    own_of_host_ = {stream, room};
  }
  if (!stream.is_ok()) return;
  own_count_ = of_cells.size();
  std::ranges::transform(of_cells, own_of_host_.data(), [](const OwnFields& of) {
    return OwnAlpha{of.cell, of.alpha1, of.alpha2};
  });
  upload(stream, own_.data(), std::span<const OwnAlpha>(own_of_host_.data(), own_count_));
}

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
  find_changed(metric);
  set_own(stream, metric.own);
  AlphaSource source{};
  source.own = own_.data();
  source.own_count = static_cast<int32_t>(own_count_);
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
