#include "client/surface/page_decoder.h"

#include <utility>

#include "common/base/check.h"
#include "common/pages/page_codec.h"

namespace burnish {

PageDecoder::PageDecoder(PageHead head, std::function<void()> on_news)
    : head_(std::move(head)),
      on_news_(std::move(on_news)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void PageDecoder::decode(PageId page, std::span<const uint8_t> bytes) {
  BURNISH_CHECK(has_room() && !has(page), "a page is decoded once");
  known_.insert(page);
  const std::lock_guard lock(mutex_);
  jobs_.push_back({page, {bytes.begin(), bytes.end()}});
  changed_.notify_one();
}

std::vector<DecodedPage> PageDecoder::take() {
  std::vector<DecodedPage> taken;
  {
    const std::lock_guard lock(mutex_);
    taken.swap(done_);
  }
  for (const DecodedPage& page : taken) known_.erase(page.id);
  return taken;
}

void PageDecoder::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    DecodedPage decoded = decode(job);
    lock.lock();
    done_.push_back(std::move(decoded));
    lock.unlock();
    on_news_();
    lock.lock();
  }
}

DecodedPage PageDecoder::decode(const Job& job) const {
  Result<Page> page = decode_page(job.bytes);
  if (!page.is_ok()) return {job.page, page.status(), {}};
  const Status fits = check_page_in_scan(*page, job.page, head_);
  if (!fits.is_ok()) return {job.page, fits, {}};
  PageMesh mesh = make_page_mesh(*page, head_.grid);
  return {job.page, std::move(page), std::move(mesh)};
}

}  // namespace burnish
