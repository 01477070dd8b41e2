#pragma once

#include <cstdint>
#include <vector>

#include "client/pages/cut_targets.h"
#include "common/pages/directory.h"

namespace burnish {

/// The parts of PageBudget, and what may stop a cut short of its targets.
enum class CutLimit { kNone, kTriangles, kVertices, kMemory, kCard };

/// The costs of a cut.
struct CutUsage {
  uint64_t triangles = 0;
  uint64_t vertices = 0;
  uint64_t resident_bytes = 0;
  uint64_t slots = 0;

  CutUsage& operator+=(const CutUsage& other);
};

/// Returns the memory of a page with its encoded bytes, decoded as in page.h.
uint64_t resident_bytes_of(const PageEntry& entry, bool has_colours);

/// Returns the first part of the budget of which the usage takes more than `part`.
CutLimit exceeded_limit(const CutUsage& usage, const PageBudget& budget, double part);

/// A cut aims at this part of its budget,
inline constexpr double kBudgetAim = 0.9;
/// and becomes finer while something moves only when it takes less than this.
inline constexpr double kBudgetRefine = 0.7;

/// A cut of a coarseness uses the pages that exceed full detail 1.05^coarseness times.
inline constexpr float kCoarsenessBase = 1.05f;
inline constexpr int kCoarsenessMax = 512;  // of any page but the root: 7·10^10 times

/// Returns the largest coarseness at which a page of this excess is used, 0..kCoarsenessMax.
int coarseness_of(float excess);

/// The usage of a picture's cut at any coarseness.
class UsageByCoarseness {
 public:
  void clear();
  /// Adds a page that is used up to this coarseness.
  void add(int coarseness, const CutUsage& usage);
  /// Sums up. Call once, after the last add().
  void sum();

  /// Needs: 0..kCoarsenessMax + 1, the last being the root alone.
  const CutUsage& at(int coarseness) const { return usage_[coarseness]; }
  /// Returns the least coarseness, not below `from`, whose cut takes at most `part` of the budget.
  int least_that_fits(const PageBudget& budget, double part, int from) const;

 private:
  std::vector<CutUsage> usage_ = std::vector<CutUsage>(kCoarsenessMax + 2);
};

/// Returns the coarseness of the next cut. It rises at once to what fits. It falls one step a
/// picture: while something moves, only far below the budget, so that the picture does not flicker;
/// at rest as far as fits, so that what rests follows from the view alone. It measures what budgets
/// take away: it may be 0 while CutTargets::take asks for less.
int next_coarseness(const UsageByCoarseness& usage, const PageBudget& budget, int last,
                    bool is_at_rest);

}  // namespace burnish
