#pragma once

#include <cstdint>
#include <vector>

#include "client/pages/cut_usage.h"
#include "client/pages/page_demand.h"
#include "common/pages/cut.h"

namespace burnish {

/// The cut of one picture, and what it waits for.
struct ChosenCut {
  PageSet set;                        ///< what is shown: a legal cut, one byte per page
  std::vector<PageId> pages;          ///< of the set, from coarse to fine
  std::vector<PageId> visible_pages;  ///< those of them that the picture draws, in the same order
  uint64_t triangles = 0;             ///< at least as many as are drawn, at most the budget's

  std::vector<WantedPage> used;      ///< what is to be shown when all is there, from fine to coarse
  std::vector<WantedBlock> blocks;   ///< unknown, the most urgent first
  CutUsage usage;                    ///< of `used`
  int coarseness = 0;                ///< as in cut_usage.h: 0 if budgets take nothing away
  CutLimit limit = CutLimit::kNone;  ///< what keeps it there; kNone: it is 0 or on its way to 0
};

}  // namespace burnish
