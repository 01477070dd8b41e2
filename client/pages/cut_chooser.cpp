#include "client/pages/cut_chooser.h"

#include <algorithm>
#include <ranges>

namespace burnish {

CutChooser::CutChooser(const KnownPages& known)
    : known_(known),
      finder_(known),
      is_used_(known.head().page_count()),
      replaced_(known.head().page_count()),
      was_shown_(known.head().page_count()) {
  cut_.set.resize(known.head().page_count());
}

const ChosenCut& CutChooser::choose(const CutQuestion& question, const FindReady& find_ready) {
  const PageDemand& demand =
      finder_.find(question.view, question.frame, question.targets, cut_.set);
  cut_.blocks = demand.blocks;
  tally(demand);
  const int last = question.is_at_rest && question.at_once ? 0 : cut_.coarseness;
  cut_.coarseness = next_coarseness(usage_, question.budget, last, question.is_at_rest);
  use(demand);
  select(find_ready);
  // Some were estimates.
  while (cut_.triangles > question.budget.triangles && cut_.used.size() > 1) {
    ++cut_.coarseness;
    use(demand);
    select(find_ready);
  }
  cut_.usage = usage_.at(cut_.coarseness);
  if (cut_.coarseness == 0)
    cut_.limit = CutLimit::kNone;
  else
    cut_.limit = exceeded_limit(usage_.at(cut_.coarseness - 1), question.budget,
                                question.is_at_rest ? kBudgetAim : kBudgetRefine);
  return cut_;
}

void CutChooser::tally(const PageDemand& demand) {
  usage_.clear();
  coarseness_.clear();
  for (const WantedPage& wanted : demand.pages) {
    const bool is_root = wanted.page == known_.head().root();
    coarseness_.push_back(is_root ? kCoarsenessMax + 1 : coarseness_of(wanted.excess));
    usage_.add(coarseness_.back(), usage_of(wanted));
  }
  usage_.sum();
}

// The directory tells how many triangles a page has, not how many replace it: half is what each
// level aims at. The patches tell it once all coarser pages were shown.
uint32_t CutChooser::replaced_by(const WantedPage& wanted) const {
  if (wanted.coarser.empty()) return 0;
  const bool is_known =
      std::ranges::all_of(wanted.coarser, [&](PageId coarser) { return was_shown_[coarser] != 0; });
  const uint32_t triangles = wanted.entry->triangles;
  return is_known ? std::min(replaced_[wanted.page], triangles) : triangles / 2;
}

CutUsage CutChooser::usage_of(const WantedPage& wanted) const {
  const PageEntry& entry = *wanted.entry;
  CutUsage usage;
  if (wanted.is_seen) usage.triangles = entry.triangles - replaced_by(wanted);
  usage.vertices = entry.vertices;
  usage.resident_bytes = resident_bytes_of(entry, known_.head().has_colours);
  usage.slots = 1;
  return usage;
}

void CutChooser::use(const PageDemand& demand) {
  for (const WantedPage& wanted : cut_.used) is_used_[wanted.page] = 0;
  cut_.used.clear();
  for (size_t i = 0; i < demand.pages.size(); ++i)
    if (coarseness_[i] >= cut_.coarseness) cut_.used.push_back(demand.pages[i]);
  for (const WantedPage& wanted : cut_.used) is_used_[wanted.page] = 1;
}

void CutChooser::select(const FindReady& find_ready) {
  for (const PageId page : cut_.pages) cut_.set[page] = 0;
  cut_.pages.clear();
  cut_.visible_pages.clear();
  cut_.triangles = 0;
  for (const WantedPage& wanted : std::views::reverse(cut_.used)) {
    if (!has_all_coarser(wanted)) continue;
    if (const Page* page = find_ready(wanted.page)) take(wanted, *page);
  }
}

bool CutChooser::has_all_coarser(const WantedPage& wanted) const {
  return std::ranges::all_of(wanted.coarser,
                             [&](PageId coarser) { return cut_.set[coarser] != 0; });
}

void CutChooser::take(const WantedPage& wanted, const Page& page) {
  cut_.set[wanted.page] = 1;
  cut_.pages.push_back(wanted.page);
  if (wanted.is_seen) cut_.visible_pages.push_back(wanted.page);
  if (was_shown_[wanted.page] == 0) {
    was_shown_[wanted.page] = 1;
    for (const PagePatch& patch : page.patches)
      if (patch.finer != kNoPage) replaced_[patch.finer] += patch.triangles;
  }
  cut_.triangles += usage_of(wanted).triangles;
}

}  // namespace burnish
