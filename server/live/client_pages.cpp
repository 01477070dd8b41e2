#include "server/live/client_pages.h"

#include <algorithm>
#include <utility>

#include "common/page_frames/page_frame_decoder.h"

namespace burnish {

namespace {

// So that one client's pages do not keep a thread from the others' frames.
constexpr size_t kPagesAtOnce = 8;

// A wish has no layouts: they come with the pages.
const std::shared_ptr<const PageLayout>& no_layout() {
  static const auto none = std::make_shared<const PageLayout>();
  return none;
}

PageChange numbers_of(const ShowPages& change) {
  PageChange numbers{change.revision, {}, change.removed};
  for (const PageId page : change.added) numbers.added.push_back({page, no_layout()});
  return numbers;
}

}  // namespace

PageFrameKind choose_kind(std::optional<PageFrameKind> present, uint64_t vertices,
                          uint64_t corners) {
  constexpr uint64_t kGain = 7, kOf = 10;
  if (!present) return cheaper_kind(vertices, corners);
  return *present == PageFrameKind::kVertices ? cheaper_kind(vertices * kGain, corners * kOf)
                                              : cheaper_kind(vertices * kOf, corners * kGain);
}

PageWishes::PageWishes(std::shared_ptr<ScanPageSource> source, const Greeting& greeting,
                       Quota::Share memory)
    : source_(std::move(source)),
      insisted_(greeting.kind),
      knows_held_(greeting.knows_held),
      kind_(greeting.kind.value_or(PageFrameKind::kVertices)),
      made_(std::make_shared<const ClientPages>(
          ClientPages{.kind = kind_, .insists = greeting.kind.has_value()})),
      memory_(std::move(memory)) {}

Result<bool> PageWishes::want(const ShowPages& change) {
  const PageChange numbers = numbers_of(change);
  const std::lock_guard lock(mutex_);
  RETURN_IF_ERROR(wanted_.check(numbers, source_->page_count()));
  const uint32_t waiting = change.revision - made_->shown.revision();
  if (waiting > kPageChangesInFlightMax)
    return resource_exhausted(std::to_string(waiting) +
                              " changes of the shown pages wait, the limit is " +
                              std::to_string(kPageChangesInFlightMax));
  ShownPages wanted = wanted_.changed(numbers);
  RETURN_IF_ERROR(grow(predict_client_bytes(wanted.pages())));  // the list, without values
  wanted_ = std::move(wanted);
  return !std::exchange(is_making_, true);
}

bool PageWishes::set_layer(bool is_there) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(has_layer_, is_there) == is_there || insisted_) return false;
  return !std::exchange(is_making_, true);
}

Result<bool> PageWishes::make_some() {
  ShownPages wanted;
  bool has_layer = false;
  {
    const std::lock_guard lock(mutex_);
    wanted = wanted_;
    has_layer = has_layer_;
  }
  bool is_whole = false;
  RETURN_IF_ERROR(load(wanted, is_whole));
  if (!is_whole) return true;
  if (const PageFrameKind kind = choose(has_layer); kind != kind_) {
    kind_ = kind;
    loaded_.clear();
    return true;
  }
  return publish(gather(wanted), has_layer);
}

// Drops pages that are not wanted any more, and loads some of the missing ones.
Status PageWishes::load(const ShownPages& wanted, bool& is_whole) {
  std::erase_if(loaded_, [&](const auto& entry) { return !wanted.shows(entry.first); });
  std::vector<PageId> missing;
  for (const ShownPage& page : wanted.pages())
    if (missing.size() <= kPagesAtOnce && !loaded_.contains(page.page))
      missing.push_back(page.page);
  is_whole = missing.size() <= kPagesAtOnce;
  missing.resize(std::min(missing.size(), kPagesAtOnce));
  ASSIGN_OR_RETURN(const ScanPageSource::Pages pages, source_->find_or_make(missing, kind_));
  for (const auto& page : pages) loaded_.emplace(page->number(), page);
  return Status::ok();
}

PageFrameKind PageWishes::choose(bool has_layer) const {
  if (insisted_) return *insisted_;
  if (has_layer) return PageFrameKind::kVertices;
  if (loaded_.empty()) return kind_;
  // Details of colours may be finer than a cell.
  if (is_colours(loaded_.rbegin()->first)) return PageFrameKind::kVertices;
  uint64_t vertices = 0, corners = 0;
  for (const auto& [number, page] : loaded_) {
    vertices += page->size.vertices;
    corners += page->size.corners;
  }
  const bool is_free = made()->pages.empty();
  return choose_kind(is_free ? std::nullopt : std::optional(kind_), vertices, corners);
}

ClientPages PageWishes::gather(const ShownPages& wanted) const {
  ClientPages made{.kind = kind_, .knows_held = knows_held_, .insists = insisted_.has_value()};
  std::vector<ShownPage> shown;
  for (const auto& [number, page] : loaded_) {
    made.pages.push_back(page);
    shown.push_back(page->evaluation.shown);
  }
  made.shown = wanted.with_layouts(std::move(shown));
  return made;
}

Result<bool> PageWishes::publish(ClientPages pages, bool has_layer) {
  const uint64_t bytes = predict_client_bytes(pages.shown.pages());
  const std::lock_guard lock(mutex_);
  RETURN_IF_ERROR(grow(bytes));
  made_ = std::make_shared<const ClientPages>(std::move(pages));
  is_making_ = wanted_.revision() != made_->shown.revision() || has_layer != has_layer_;
  return is_making_;
}

// Never gives anything back: the encoder still remembers frames of the earlier pages.
Status PageWishes::grow(uint64_t bytes) {
  return bytes > memory_.amount() ? memory_.resize(bytes) : Status::ok();
}

std::shared_ptr<const ClientPages> PageWishes::made() const {
  const std::lock_guard lock(mutex_);
  return made_;
}

bool PageWishes::is_beginning() const {
  const std::lock_guard lock(mutex_);
  return is_making_ && made_->pages.empty();
}

void PageWishes::note_encoder_bytes(uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  bytes = std::max(
      {bytes, predict_client_bytes(made_->shown.pages()), predict_client_bytes(wanted_.pages())});
  if (bytes < memory_.amount()) (void)memory_.resize(bytes);  // less never fails
}

uint64_t PageWishes::byte_count() const {
  const std::lock_guard lock(mutex_);
  return wanted_.pages().size_bytes();
}

}  // namespace burnish
