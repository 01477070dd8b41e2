#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "server/fields/alphas.h"

namespace burnish {

/// α1 and α2 of every cell and the held lines through the metrics of a session, and what each
/// metric changes of them.
class ChangingAlphas {
 public:
  /// Needs: prepared outlives this.
  explicit ChangingAlphas(const PreparedMesh& prepared) : prepared_(prepared) {}

  /// Takes the next metric. Returns the cells whose α or lines change, rising; at first all cells.
  /// With the last curve it looks only at cells with their own α, before or now. Needs: lines of
  /// the same cells are the same lines.
  std::vector<int32_t> take(const MetricView& metric);

  const CellAlphas& latest() const { return alphas_; }
  const LineView& held() const { return held_; }  ///< as long as the last metric's lives
  uint64_t byte_count() const;

 private:
  std::vector<int32_t> take_all(const MetricView& metric);
  std::vector<int32_t> take_own(const MetricView& metric);
  std::vector<int32_t> take_lines(const MetricView& metric);

  const PreparedMesh& prepared_;
  CellAlphas alphas_;
  std::optional<TransferCurve> curve_;
  std::vector<int32_t> own_;         // cells with their own α, rising
  std::vector<int32_t> line_cells_;  // rising
  LineView held_;
};

}  // namespace burnish
