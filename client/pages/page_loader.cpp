#include "client/pages/page_loader.h"

#include <algorithm>

#include "common/base/heap_sort.h"

namespace burnish {

// A hand that stops for a moment must not wait for a fine picture, if pictures are slow.
static constexpr std::chrono::milliseconds kRest{300};

PageLoader::PageLoader(PageHead head, const PageBudget& budget, bool is_software)
    : budget_(budget),
      is_software_(is_software),
      known_(std::move(head)),
      chooser_(known_),
      cache_(budget) {}

const ChosenCut& PageLoader::look(const PictureQuestion& question, Time now) {
  see(question, now);
  lacks_values_ = false;
  chooser_.choose(cut_question(question), [&](PageId page) { return find_ready(page, question); });
  take_stock();
  put_on_card();
  requests_.make_plan(needs_.missing, question.link, now,
                      [this](PageItem item) { return is_wanted(item); });
  return cut();
}

// Full detail is for pictures at rest that are all there: it must not hold up their values.
void PageLoader::see(const PictureQuestion& question, Time now) {
  const bool is_new =
      !has_looked_ || question.surface_moves || question.view != view_ || question.frame != frame_;
  if (is_new) moved_at_ = now;
  const bool is_slow = question.moving_triangles_max > 0;
  is_at_rest_ = !is_new && (!is_slow || now - moved_at_ >= kRest);
  wants_full_ = is_at_rest_ && (wants_full_ || (needs_.open_in_view == 0 && !lacks_values_));
  is_server_limit_ = !question.surface_moves && question.server_vertices_max > 0;
  view_ = question.view;
  frame_ = question.frame;
  has_looked_ = true;
}

CutQuestion PageLoader::cut_question(const PictureQuestion& question) const {
  CutQuestion asked = {question.view, question.frame, {}, budget_, is_at_rest_};
  if (question.surface_moves) {
    asked.targets = moving_surface_targets();
    if (question.frame_vertices_max > 0) asked.budget.vertices = question.frame_vertices_max;
  } else {
    asked.targets = wants_full_ && !question.rests_early ? full_targets(is_software_)
                                                         : prompt_targets(is_software_);
  }
  asked.at_once = question.moving_triangles_max > 0;  // each step would be a slow picture
  if (question.moving_triangles_max > 0 && !is_at_rest_)
    asked.budget.triangles = std::min(asked.budget.triangles, question.moving_triangles_max);
  if (question.server_vertices_max > 0)
    asked.budget.vertices = std::min(asked.budget.vertices, question.server_vertices_max);
  return asked;
}

const Page* PageLoader::find_ready(PageId page, const PictureQuestion& question) {
  const CachedPage* cached = cache_.find(page);
  if (cached == nullptr || cached->state != PageState::kOnCard) return nullptr;
  if (!question.has_values || question.has_values(page)) return cached->page.get();
  lacks_values_ = true;
  return nullptr;
}

// Keeps what the cut uses, and sorts it by what it still needs.
void PageLoader::take_stock() {
  needs_ = {};
  cache_.begin_picture();
  for (const WantedBlock& wanted : cut().blocks) {
    const PageItem item = PageItem::of_block(wanted.block);
    const uint32_t bytes = known_.head().blocks[wanted.block].bytes;
    if (make_room_for_blocks(needs_.missing.size() + 1))
      miss({item, bytes, wanted.excess}, wanted.is_seen);
    else
      ++needs_.blocks_left_out;
  }
  for (const WantedPage& wanted : cut().used) take_stock_of(wanted);
  heap_sort(needs_.held, is_more_urgent);
  to_decode_.clear();
  for (const MissingItem& one : needs_.held) to_decode_.push_back(one.item.number);
}

void PageLoader::take_stock_of(const WantedPage& wanted) {
  const MissingItem item = {PageItem::of_page(wanted.page), wanted.entry->bytes, wanted.excess};
  const CachedPage* cached = cache_.use(wanted.page);
  if (cached == nullptr) return miss(item, wanted.is_seen);
  if (cached->state == PageState::kOnCard) return;
  (cached->state == PageState::kHeld ? needs_.held : needs_.decoded).push_back(item);
  ++needs_.open;
  if (wanted.is_seen) ++needs_.open_in_view;
}

void PageLoader::miss(const MissingItem& missing, bool is_seen) {
  if (requests_.failures().is_given_up(missing.item)) {
    if (is_seen) ++needs_.failed;
    return;
  }
  needs_.missing.push_back(missing);
  ++needs_.open;
  if (!is_seen) return;
  ++needs_.open_in_view;
  needs_.bytes_left += missing.bytes;
}

void PageLoader::put_on_card() {
  heap_sort(needs_.decoded, is_more_urgent);
  for (const MissingItem& one : needs_.decoded)
    if (!place(one.item.number)) return;
}

bool PageLoader::place(PageId page) {
  if (!cache_.place(page)) return false;
  uploads_.push_back(page);
  return true;
}

// Forgets blocks that the picture did not look at.
bool PageLoader::make_room_for_blocks(size_t count) {
  for (uint32_t block = 0; block < known_.block_count(); ++block) {
    if (known_.known_blocks() + count <= budget_.directory_blocks) return true;
    if (!chooser_.has_visited(block)) known_.forget(block);
  }
  return known_.known_blocks() + count <= budget_.directory_blocks;
}

bool PageLoader::is_wanted(PageItem item) const {
  if (item.kind == PageItem::Kind::kPage) return chooser_.is_used(item.number);
  return std::ranges::find(cut().blocks, item.number, &WantedBlock::block) != cut().blocks.end();
}

std::vector<PageUpload> PageLoader::take_uploads() {
  std::vector<PageUpload> uploads;
  for (const PageId page : uploads_) {
    const CachedPage* cached = cache_.find(page);
    if (cached != nullptr && cached->state == PageState::kOnCard)
      uploads.push_back({page, cached->slot, cached->page});
  }
  uploads_.clear();
  return uploads;
}

bool PageLoader::is_settled() const {
  const bool is_coarseness_final = cut().coarseness == 0 || cut().limit != CutLimit::kNone;
  return wants_full_ && is_coarseness_final && needs_.open == 0 && !lacks_values_;
}

CutReason PageLoader::reason() const {
  if (needs_.open_in_view > 0 || lacks_values_ || !has_looked_) return CutReason::kLoading;
  if (!wants_full_) return CutReason::kMoving;
  if (needs_.failed > 0) return CutReason::kFailed;
  if (needs_.blocks_left_out > 0) return CutReason::kMemory;
  switch (cut().limit) {
    case CutLimit::kTriangles:
      return CutReason::kTriangles;
    case CutLimit::kVertices:
      return is_server_limit_ ? CutReason::kServer : CutReason::kFrame;
    case CutLimit::kMemory:
      return CutReason::kMemory;
    case CutLimit::kCard:
      return CutReason::kCard;
    case CutLimit::kNone:
      break;
  }
  return cut().coarseness == 0 ? CutReason::kNone : CutReason::kMoving;
}

CutStatus PageLoader::status() const {
  CutStatus status;
  status.reason = reason();
  status.is_full_detail = status.reason == CutReason::kNone;
  status.triangles_drawn = cut().triangles;
  status.triangles_in_view = scan_triangles_in_view(known_, view_, frame_.largest_move);
  status.bytes_left = needs_.bytes_left;
  status.failed_items = needs_.failed;
  return status;
}

}  // namespace burnish
