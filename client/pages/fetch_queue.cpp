#include "client/pages/fetch_queue.h"

#include <algorithm>

#include "common/service/scan_pages.h"

namespace burnish {

static constexpr uint64_t kUsualPartBytes = 10'000;  // until some have come

void FetchQueue::ask(PageItem item) {
  if (open_.insert(item).second && !under_way_.contains(item))
    (item.is_of_sheets() ? waiting_sheets_ : waiting_).push_back(item);
}

std::vector<PageItem> FetchQueue::take_batch() {
  const uint64_t part_bytes =
      parts_ == 0 ? kUsualPartBytes : std::max(bytes_ / parts_, uint64_t{1});
  const uint64_t parts_max =
      std::clamp(kFetchBytesMax / part_bytes, uint64_t{1}, uint64_t{kPagePartsPerFetchMax});
  std::vector<PageItem> batch;
  fill(batch, waiting_, parts_max);
  if (batch.empty()) fill(batch, waiting_sheets_, parts_max);
  return batch;
}

void FetchQueue::fill(std::vector<PageItem>& batch, std::deque<PageItem>& from,
                      uint64_t parts_max) {
  while (!from.empty() && batch.size() < parts_max) {
    const PageItem item = from.front();
    if (!batch.empty() && batch.front().version != item.version) return;
    from.pop_front();
    if (is_open(item) && under_way_.insert(item).second) batch.push_back(item);
  }
}

bool FetchQueue::arrive(PageItem item, uint64_t bytes) {
  ++parts_;
  bytes_ += bytes;
  under_way_.erase(item);
  return open_.erase(item) > 0;
}

std::vector<PageItem> FetchQueue::end(const std::vector<PageItem>& batch) {
  std::vector<PageItem> left;
  for (const PageItem item : batch)
    if (under_way_.erase(item) > 0 && open_.erase(item) > 0) left.push_back(item);
  return left;
}

std::vector<PageItem> FetchQueue::give_up_waiting() {
  std::vector<PageItem> left;
  for (std::deque<PageItem>* waiting : {&waiting_, &waiting_sheets_}) {
    for (const PageItem item : *waiting)
      if (!under_way_.contains(item) && open_.erase(item) > 0) left.push_back(item);
    waiting->clear();
  }
  return left;
}

}  // namespace burnish
