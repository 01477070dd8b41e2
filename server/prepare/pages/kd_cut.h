#pragma once

#include <span>
#include <vector>

#include "common/base/loop_progress.h"
#include "server/prepare/pages/triangle_runs.h"

namespace burnish {

/// When a piece is a page, and where a larger one is cut.
struct KdRule {
  std::span<const Triangle> triangles;
  size_t triangles_wanted = 0;  ///< of a page
  double ratio = 0.5;           ///< how much of a piece goes to its first part
  PageTexels texels = {};
  bool keeps_dense_parts = true;          ///< sharp, if texels matter
  std::span<const Vec3i> positions = {};  ///< per vertex; only where texels matter
};

/// Cuts pieces of a level in two until each fits a page.
class KdCut {
 public:
  /// Marks the first triangle of each page in `is_start`. Shapes: as many as centres. Needs: `loop`
  /// outlives the cutting, which ends when it is cancelled.
  KdCut(const KdRule& rule, std::span<TriangleCentre> centres, std::span<uint8_t> is_start,
        LoopProgress& loop)
      : rule_(rule), centres_(centres), is_start_(is_start), loop_(loop) {}

  /// Orders the centres from `begin` to `end` by page. Hands large parts to the threads of the
  /// surrounding parallel region, and returns before they are done.
  void split(size_t begin, size_t end) const;

 private:
  bool fits_page(std::span<const TriangleCentre> piece) const;
  bool fits_sheet(std::span<const TriangleCentre> piece) const;
  bool fits_dense_parts(std::span<const TriangleCentre> piece) const;
  size_t size_of_first_part(size_t size) const;

  KdRule rule_;
  std::span<TriangleCentre> centres_;
  std::span<uint8_t> is_start_;
  LoopProgress& loop_;
};

}  // namespace burnish
