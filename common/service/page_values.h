#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/limits.h"
#include "common/base/record.h"
#include "common/pages/page.h"
#include "common/service/session_info.h"

namespace burnish {

/// Limit of the pages of one request for values.
inline constexpr size_t kValuedPagesMax = kShownPagesMax;

/// Asks for a value of the cell of each vertex, for some pages.
struct PageValuesWish {
  std::string session;  ///< name or id
  CellValue value = CellValue::kBeta;
  std::vector<PageId> pages;  ///< 1 to kValuedPagesMax
};

/// Values of a page's vertices, rounded to 255 steps between the least and the largest.
struct PageValues {
  PageId page = 0;
  float low = 0;
  float high = 0;
  std::vector<uint8_t> steps;  ///< one per vertex, in the page's order; empty: all are low

  /// Returns the value at a vertex. Needs: a vertex of the page.
  float at(size_t vertex) const;
};
BURNISH_RECORD(PageValues, page, low, high)

/// Rounds one value per vertex. Needs: finite values.
PageValues pack_page_values(PageId page, std::span<const float> values);

}  // namespace burnish
