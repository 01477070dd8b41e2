#pragma once

#include <algorithm>
#include <string_view>

namespace burnish {

/// Relaxes the depths of the V-cycle.
enum class Smoother {
  kSchwarz,
  kCellBlocks,
  kChebyshevJacobi,
  kGaussSeidel,
  kSlices,
  kBlockedSlices,
};

struct NamedSmoother {
  Smoother smoother;
  std::string_view name;  ///< as users write it
  std::string_view what;
};

/// Every smoother, the default first.
inline constexpr NamedSmoother kSmoothers[] = {
    {Smoother::kSchwarz, "schwarz", "Chebyshev on additive Schwarz over cells"},
    {Smoother::kCellBlocks, "cell-blocks", "Gauss-Seidel by the 8x8 blocks of cells"},
    {Smoother::kChebyshevJacobi, "chebyshev-jacobi", "Chebyshev on the diagonal"},
    {Smoother::kGaussSeidel, "gauss-seidel", "point Gauss-Seidel in eight colours"},
    {Smoother::kSlices, "slices", "the paper's point Gauss-Seidel by slices"},
    {Smoother::kBlockedSlices, "blocked-slices", "Gauss-Seidel by slices with temporal blocking"},
};

/// Returns whether the smoother relaxes corners of one parity, or bricks of cells, at the same
/// time. These corners must then have no entry with each other.
constexpr bool goes_by_colours(Smoother smoother) {
  return smoother != Smoother::kSchwarz && smoother != Smoother::kChebyshevJacobi;
}

constexpr std::string_view name_of(Smoother smoother) {
  return std::ranges::find(kSmoothers, smoother, &NamedSmoother::smoother)->name;
}

}  // namespace burnish
