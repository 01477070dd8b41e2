#include "server/solver/multi/shard_fields.h"

#include <algorithm>
#include <functional>

#include "server/fields/held_lines.h"

namespace burnish {

static constexpr int64_t kParallelMin = 256;  // stretches; below, waking threads takes longer

ShardFields::ShardFields(std::span<const int32_t> cells)
    : cells_(cells),
      follow_(cells.size(), 1),
      own_(cells.size(), 0),
      is_painted_((cells.size() + CellPaint::kStretch - 1) / CellPaint::kStretch, 0) {}

// Takes what belongs to the shard's cells. Shapes: both rise.
template <typename OfCell>
static void take_of_cells(std::span<const int32_t> cells, std::span<const OfCell> whole,
                          std::vector<OfCell>& taken) {
  taken.clear();
  auto next = cells.begin();
  for (const OfCell& of : whole) {
    next = std::lower_bound(next, cells.end(), of.cell);
    if (next == cells.end()) break;
    if (*next != of.cell) continue;
    taken.push_back(of);
    taken.back().cell = static_cast<int32_t>(next - cells.begin());
  }
}

MetricView ShardFields::metric(const MetricView& whole) {
  take_of_cells(cells_, whole.own, own_fields_);
  return {whole.curve, own_fields_, held(whole.held)};
}

LineView ShardFields::held(const LineView& whole) {
  take_of_cells(cells_, whole.lines, lines_);
  first_line_ = first_lines(lines_, cells_.size());
  return {lines_, first_line_};
}

FieldsView ShardFields::constraint(const FieldsView& whole) {
  find_painted(whole.paint);
  const auto painted = static_cast<int64_t>(painted_.size());
#pragma omp parallel for schedule(static) if (painted >= kParallelMin)
  for (int64_t i = 0; i < painted; ++i) take_stretch(whole.paint, painted_[i]);
  FieldsView view{};
  view.gradient_scale = whole.gradient_scale;
  view.paint = {follow_, own_, is_painted_};
  view.target = target(whole.target);
  return view;
}

// Takes the values of the shard's cells.
template <typename Value>
static void take_values(std::span<const int32_t> cells, std::span<const Value> whole,
                        std::vector<Value>& taken) {
  taken.resize(whole.empty() ? 0 : cells.size());
  for (size_t c = 0; c < taken.size(); ++c) taken[c] = whole[cells[c]];
}

TargetView ShardFields::target(const TargetView& whole) {
  if (!whole.is_active()) {
    target_ = {};
    target_part_ = {};
    return {};
  }
  if (target_.empty() || whole.version != target_version_)
    take_values(cells_, whole.cells, target_);
  if (target_part_.empty() || whole.part_version != target_part_version_)
    take_values(cells_, whole.part, target_part_);
  target_version_ = whole.version;
  target_part_version_ = whole.part_version;
  return {target_, whole.strength, whole.version, target_part_, whole.part_version};
}

// Few stretches have paint. So one thread, which need not wake others, has looked at all of them
// soon. A stretch's cells rise, so they lie in some stretches of the whole scan from a first to a
// last.
void ShardFields::find_painted(const CellPaint& whole) {
  painted_.clear();
  for (size_t stretch = 0; stretch < is_painted_.size(); ++stretch) {
    const size_t end = std::min((stretch + 1) * CellPaint::kStretch, cells_.size());
    const size_t first = cells_[stretch * CellPaint::kStretch] / CellPaint::kStretch;
    const size_t last = cells_[end - 1] / CellPaint::kStretch;
    const bool has_paint =
        std::ranges::any_of(whole.is_painted.subspan(first, last - first + 1), std::identity());
    if (has_paint || is_painted_[stretch]) painted_.push_back(static_cast<int32_t>(stretch));
    is_painted_[stretch] = has_paint;
  }
}

void ShardFields::take_stretch(const CellPaint& whole, size_t stretch) {
  const size_t begin = stretch * CellPaint::kStretch;
  const size_t end = std::min(begin + CellPaint::kStretch, cells_.size());
  for (size_t c = begin; c < end; ++c) {
    follow_[c] = whole.follow[cells_[c]];
    own_[c] = whole.own[cells_[c]];
  }
}

uint64_t ShardFields::byte_count() const {
  return own_fields_.capacity() * sizeof(OwnFields) + lines_.capacity() * sizeof(LineMass) +
         first_line_.capacity() * sizeof(int32_t) +
         (follow_.capacity() + own_.capacity()) * sizeof(float) + is_painted_.capacity() +
         painted_.capacity() * sizeof(int32_t) + target_.capacity() * sizeof(TargetGradient) +
         target_part_.capacity() * sizeof(float);
}

}  // namespace burnish
