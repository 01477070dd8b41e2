#include "client/connection/page_fetch_worker.h"

#include <algorithm>
#include <utility>

#include "client/connection/channel.h"
#include "client/connection/page_calls.h"

namespace burnish {

static constexpr int kCallsMax = 2;  // one asks while the other one's pages are on the link

static std::string name_of(PageItem item) {
  return (item.kind == PageItem::Kind::kPage ? "page " : "block ") + std::to_string(item.number);
}

PageFetcher::Worker::Worker(std::string server, ConnectionTrust trust, std::string scan,
                            std::function<void()> on_news, std::shared_ptr<PageDisk> disk)
    : server_(std::move(server)),
      trust_(std::move(trust)),
      scan_(std::move(scan)),
      on_news_(std::move(on_news)),
      disk_(std::move(disk)) {
  for (int i = 0; i < kCallsMax; ++i) threads_.emplace_back([this] { run(); });
}

PageFetcher::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
    for (Call* call : calls_) call->context.TryCancel();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void PageFetcher::Worker::ask(std::span<const PageItem> items) {
  {
    const std::lock_guard lock(mutex_);
    for (const PageItem item : items) queue_.ask(item);
  }
  changed_.notify_all();
}

// A call that brings nothing useful any more would hold up the others.
void PageFetcher::Worker::cancel(std::span<const PageItem> items) {
  const std::lock_guard lock(mutex_);
  for (const PageItem item : items) queue_.cancel(item);
  for (Call* call : calls_)
    if (!is_useful(*call) && !std::exchange(call->is_cancelled, true)) call->context.TryCancel();
}

std::vector<PageFetcher::Arrival> PageFetcher::Worker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(arrivals_, {});
}

LinkSpeed PageFetcher::Worker::speed() const {
  const std::lock_guard lock(mutex_);
  return meter_.speed();
}

// A call that has brought all ends by itself.
bool PageFetcher::Worker::is_useful(const Call& call) const {
  return call.coming == 0 ||
         std::ranges::any_of(call.items, [&](PageItem item) { return queue_.is_open(item); });
}

void PageFetcher::Worker::run() {
  for (;;) {
    std::vector<PageItem> batch = next_batch();
    if (batch.empty()) return;
    batch = look_on_disk(batch);
    if (!batch.empty()) fetch(std::move(batch));
  }
}

std::vector<PageItem> PageFetcher::Worker::next_batch() {
  std::unique_lock lock(mutex_);
  std::vector<PageItem> batch;
  changed_.wait(lock, [&] {
    if (!is_stopping_) batch = queue_.take_batch();
    return is_stopping_ || !batch.empty();
  });
  return batch;
}

// Returns what the disk does not have.
std::vector<PageItem> PageFetcher::Worker::look_on_disk(const std::vector<PageItem>& batch) {
  if (!disk_) return batch;
  std::vector<PageItem> missing;
  for (const PageItem item : batch) {
    auto found = disk_->find(item);
    if (!found.is_ok()) {
      missing.push_back(item);
      continue;
    }
    const std::lock_guard lock(mutex_);
    const uint64_t bytes = found->size();
    if (queue_.come(item, bytes)) arrivals_.push_back({item, std::move(found)});
  }
  if (missing.size() < batch.size()) tell();
  return missing;
}

void PageFetcher::Worker::fetch(std::vector<PageItem> items) {
  Call call;
  call.items = std::move(items);
  call.coming = call.items.size();
  {
    const std::lock_guard lock(mutex_);
    if (is_stopping_) return;
    call.is_cancelled = !is_useful(call);
    calls_.push_back(&call);
  }
  end(call, call.is_cancelled ? Status::ok() : listen(call));
}

Status PageFetcher::Worker::listen(Call& call) {
  ASSIGN_OR_RETURN(const auto stub, this->stub());
  PagesWish wish{.scan = scan_, .blocks = {}, .pages = {}};
  for (const PageItem item : call.items)
    (item.kind == PageItem::Kind::kPage ? wish.pages : wish.blocks).push_back(item.number);
  call.began = std::chrono::steady_clock::now();
  const Connection::PageTaker taker{
      .block =
          [&](PagePart part) {
            return on_part(call, PageItem::of_block(part.number), std::move(part.bytes));
          },
      .page =
          [&](PagePart part) {
            return on_part(call, PageItem::of_page(part.number), std::move(part.bytes));
          }};
  return fetch_parts(server_, *stub, call.context, wish, taker);
}

bool PageFetcher::Worker::on_part(Call& call, PageItem item, std::vector<uint8_t> bytes) {
  const Time now = std::chrono::steady_clock::now();
  if (disk_) disk_->keep(item, bytes);
  bool goes_on;
  {
    const std::lock_guard lock(mutex_);
    meter_.on_part(bytes.size(), now);
    if (!std::exchange(call.has_begun, true)) meter_.on_first_part(call.began, now);
    const uint64_t size = bytes.size();
    if (queue_.come(item, size)) arrivals_.push_back({item, std::move(bytes)});
    if (call.coming > 0) --call.coming;
    goes_on = is_useful(call) && !is_stopping_;
    if (!goes_on) call.is_cancelled = true;
  }
  tell();
  return goes_on;
}

// Items that were asked for again after the call was cancelled wait for another call.
void PageFetcher::Worker::end(Call& call, const Status& why) {
  {
    const std::lock_guard lock(mutex_);
    std::erase(calls_, &call);
    if (call.has_begun) meter_.on_end();
    std::vector<PageItem> left = queue_.end(call.items);
    if (why.code() == StatusCode::kUnavailable) {
      stub_.reset();
      std::ranges::copy(queue_.give_up_waiting(), std::back_inserter(left));
    }
    for (const PageItem item : left) {
      if (call.is_cancelled)
        queue_.ask(item);
      else if (why.is_ok())
        arrivals_.push_back({item, data_loss("server " + server_ + " left out " + name_of(item))});
      else
        arrivals_.push_back({item, why});
    }
    if (left.empty() || is_stopping_) return;
  }
  changed_.notify_all();
  tell();
}

void PageFetcher::Worker::tell() const {
  if (on_news_) on_news_();
}

// A channel of its own: pages do not hold up frames. After a loss another one connects at once,
// without gRPC's back-off, and with certificates as they are then.
Result<std::shared_ptr<v1::Library::Stub>> PageFetcher::Worker::stub() {
  const std::lock_guard lock(mutex_);
  if (stub_) return stub_;
  ASSIGN_OR_RETURN(const auto channel, make_channel(server_, trust_, Sharing::kOwn));
  stub_ = v1::Library::NewStub(channel);
  return stub_;
}

}  // namespace burnish
