#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/fields/fields_view.h"

namespace burnish {

/// α and β of a shard's cells, taken from those of the whole scan.
class ShardFields {
 public:
  /// `cells`: the shard's cells in the whole scan, rising. They must live longer.
  explicit ShardFields(std::span<const int32_t> cells);

  /// Returns the shard's part of a metric. Valid until the next call.
  MetricView metric(const MetricView& whole);
  /// Returns the shard's part of β, likewise. Its metric is empty.
  FieldsView constraint(const FieldsView& whole);

  uint64_t byte_count() const;

 private:
  LineView held(const LineView& whole);
  TargetView target(const TargetView& whole);
  void find_painted(const CellPaint& whole);
  void take_stretch(const CellPaint& whole, size_t stretch);

  std::span<const int32_t> cells_;
  std::vector<OwnFields> own_fields_;
  std::vector<LineMass> lines_;
  std::vector<int32_t> first_line_;
  std::vector<float> follow_, own_;
  std::vector<uint8_t> is_painted_;     // per stretch
  std::vector<TargetGradient> target_;  // empty without
  std::vector<float> target_part_;      // empty: 1 in all
  uint64_t target_version_ = 0, target_part_version_ = 0;
  std::vector<int32_t> painted_;  // stretches that have paint or had some at the last call
};

}  // namespace burnish
