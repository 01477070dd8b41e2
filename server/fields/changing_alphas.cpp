#include "server/fields/changing_alphas.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burnish {

std::vector<int32_t> ChangingAlphas::take(const MetricView& metric) {
  const bool is_same_curve = curve_ && *curve_ == *metric.curve;
  std::vector<int32_t> changed = is_same_curve ? take_own(metric) : take_all(metric);
  curve_ = *metric.curve;
  own_.clear();
  for (const OwnFields& own : metric.own) own_.push_back(own.cell);
  const std::vector<int32_t> lines = take_lines(metric);
  if (lines.empty()) return changed;
  std::vector<int32_t> either;
  std::ranges::set_union(changed, lines, std::back_inserter(either));
  return either;
}

// Returns the cells whose lines come or go.
std::vector<int32_t> ChangingAlphas::take_lines(const MetricView& metric) {
  held_ = metric.held;
  std::vector<int32_t> now, changed;
  for (const LineMass& line : held_.lines) now.push_back(line.cell);
  std::ranges::set_symmetric_difference(line_cells_, now, std::back_inserter(changed));
  line_cells_ = std::move(now);
  return changed;
}

std::vector<int32_t> ChangingAlphas::take_all(const MetricView& metric) {
  const CellAlphas before = std::exchange(alphas_, {});
  evaluate(metric, prepared_, alphas_);
  const bool is_first = before.alpha1.empty();
  std::vector<int32_t> changed;
  for (size_t c = 0; c < alphas_.alpha1.size(); ++c)
    if (is_first || alphas_.alpha1[c] != before.alpha1[c] || alphas_.alpha2[c] != before.alpha2[c])
      changed.push_back(static_cast<int32_t>(c));
  return changed;
}

std::vector<int32_t> ChangingAlphas::take_own(const MetricView& metric) {
  std::vector<int32_t> now, either, changed;
  for (const OwnFields& own : metric.own) now.push_back(own.cell);
  std::ranges::set_union(own_, now, std::back_inserter(either));
  auto own = metric.own.begin();
  for (const int32_t c : either) {
    CellAlpha next = follow_curve(*metric.curve, prepared_.curvature[c]);
    if (own != metric.own.end() && own->cell == c) {
      next = {own->alpha1, own->alpha2};
      ++own;
    }
    if (next == CellAlpha{alphas_.alpha1[c], alphas_.alpha2[c]}) continue;
    alphas_.alpha1[c] = next.first;
    alphas_.alpha2[c] = next.second;
    changed.push_back(c);
  }
  return changed;
}

uint64_t ChangingAlphas::byte_count() const {
  return (alphas_.alpha1.capacity() + alphas_.alpha2.capacity()) * sizeof(float) +
         (own_.capacity() + line_cells_.capacity()) * sizeof(int32_t);
}

}  // namespace burnish
