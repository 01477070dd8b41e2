#include <string>

#include "client/pages/page_loader.h"

namespace burnish {

namespace {

Status check_count(PageId page, const char* what, size_t count, size_t listed) {
  if (count == listed) return Status::ok();
  return data_loss("page " + std::to_string(page) + " has " + std::to_string(count) + " " + what +
                   ": the directory lists " + std::to_string(listed));
}

Status check_decoded(PageId id, const Result<Page>& page, const PageEntry& entry) {
  RETURN_IF_ERROR(page.status());
  RETURN_IF_ERROR(check_count(id, "vertices", page->positions.size(), entry.vertices));
  return check_count(id, "triangles", page->triangles.size(), entry.triangles);
}

}  // namespace

void PageLoader::on_block(uint32_t index, Result<DirectoryBlock> block, Time now) {
  if (index >= known_.block_count()) return;
  const PageItem item = PageItem::of_block(index);
  requests_.on_arrival(item);
  if (!block.is_ok()) return requests_.on_failure(item, block.status(), now);
  requests_.failures().on_success(item);
  if (known_.find_block(index) != nullptr || !make_room_for_blocks(1)) return;
  known_.add(index, std::move(*block));
}

void PageLoader::on_page(PageId page, std::vector<uint8_t> bytes, Time now) {
  if (page >= known_.head().page_count()) return;
  const PageItem item = PageItem::of_page(page);
  requests_.on_arrival(item);
  const PageEntry* entry = known_.find(page);
  if (entry == nullptr || cache_.find(page) != nullptr) return;
  const Status size = check_count(page, "bytes", bytes.size(), entry->bytes);
  if (!size.is_ok()) return requests_.on_failure(item, size, now);
  cache_.hold(page, std::move(bytes));  // without room it is asked for again, if it is wanted
}

std::span<const uint8_t> PageLoader::bytes_of(PageId page) const {
  return cache_.find(page)->bytes;
}

void PageLoader::on_decoded(PageId id, Result<Page> page, Time now) {
  const PageEntry* entry = known_.find(id);
  if (entry == nullptr || cache_.state_of(id) != PageState::kHeld) return;
  const PageItem item = PageItem::of_page(id);
  const Status good = check_decoded(id, page, *entry);
  if (!good.is_ok()) {
    cache_.drop(id);
    return requests_.on_failure(item, good, now);
  }
  requests_.failures().on_success(item);
  if (!cache_.decode(id, std::make_shared<const Page>(std::move(*page)))) return;
  if (chooser_.is_used(id)) place(id);
}

void PageLoader::on_failure(PageItem item, const Status& why, Time now) {
  requests_.on_failure(item, why, now);
}

}  // namespace burnish
