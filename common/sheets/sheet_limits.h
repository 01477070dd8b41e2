#pragma once

#include <cstddef>
#include <cstdint>

namespace burnish {

// Facts of the sheet format (sheet_format.h), and what its readers bound.

inline constexpr int kSheetGutter = 4;                // texels around each chart; carry two mips
inline constexpr int kChartTexelsMax = 1000;          // a side of a chart, without its gutter
inline constexpr int kSheetSideMax = 1024;            // texels
inline constexpr size_t kSheetsPerPageMax = 8;        // one per halving
inline constexpr float kSheetDensityEnd = 0x1p40f;    // texels per file unit
inline constexpr uint32_t kSheetBytesMax = 1u << 23;  // encoded
inline constexpr uint32_t kChartBytesMax = 1u << 17;  // encoded
inline constexpr int kChartTexelsMin = 2 * kSheetGutter + 1;  // a side with the gutter

}  // namespace burnish
