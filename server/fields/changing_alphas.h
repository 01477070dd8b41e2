#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "server/fields/alphas.h"

namespace burnish {

/// α1 and α2 of every cell through the metrics of a session, and what each metric changes of them.
class ChangingAlphas {
 public:
  /// Needs: prepared outlives this.
  explicit ChangingAlphas(const PreparedMesh& prepared) : prepared_(prepared) {}

  /// Takes the next metric. Returns the cells whose α change, rising; at first all cells. With the
  /// last curve it looks only at cells with their own α, before or now.
  std::vector<int32_t> take(const MetricView& metric);

  const CellAlphas& latest() const { return alphas_; }
  uint64_t byte_count() const;

 private:
  std::vector<int32_t> take_all(const MetricView& metric);
  std::vector<int32_t> take_own(const MetricView& metric);

  const PreparedMesh& prepared_;
  CellAlphas alphas_;
  std::optional<TransferCurve> curve_;
  std::vector<int32_t> own_;  // cells with their own α, rising
};

}  // namespace burnish
