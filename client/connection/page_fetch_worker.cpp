#include "client/connection/page_fetch_worker.h"

#include <optional>
#include <utility>

#include "client/connection/channel.h"
#include "client/connection/connection_state.h"
#include "client/connection/page_calls.h"
#include "client/connection/sheet_calls.h"
#include "client/pages/fetch_wishes.h"

namespace burnish {

PageFetcher::Worker::Worker(std::shared_ptr<ServerRoute> route, ConnectionTrust trust,
                            std::string scan, std::function<void()> on_news,
                            std::shared_ptr<PageDisk> disk)
    : route_(std::move(route)),
      trust_(std::move(trust)),
      scan_(std::move(scan)),
      on_news_(std::move(on_news)),
      disk_(std::move(disk)),
      delivery_(route_->address()) {
  for (int i = 0; i < kFetchCallsMax; ++i) threads_.emplace_back([this] { run(); });
}

PageFetcher::Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
    for (const auto& [call, context] : contexts_) context->TryCancel();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void PageFetcher::Worker::ask(std::span<const PageItem> items) {
  {
    const std::lock_guard lock(mutex_);
    delivery_.ask(items);
  }
  changed_.notify_all();
}

void PageFetcher::Worker::cancel(std::span<const PageItem> items) {
  const std::lock_guard lock(mutex_);
  for (const Call call : delivery_.cancel(items)) contexts_.at(call)->TryCancel();
}

std::vector<PageSource::Arrival> PageFetcher::Worker::take() {
  const std::lock_guard lock(mutex_);
  return delivery_.take();
}

LinkSpeed PageFetcher::Worker::speed() const {
  const std::lock_guard lock(mutex_);
  return delivery_.speed();
}

void PageFetcher::Worker::run() {
  for (;;) {
    std::vector<PageItem> batch = next_batch();
    if (batch.empty()) return;
    batch = look_on_disk(batch);
    if (!batch.empty()) fetch(batch);
  }
}

std::vector<PageItem> PageFetcher::Worker::next_batch() {
  std::unique_lock lock(mutex_);
  std::vector<PageItem> batch;
  changed_.wait(lock, [&] {
    if (!is_stopping_) batch = delivery_.next_batch();
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
    delivery_.on_found(item, std::move(*found));
  }
  if (missing.size() < batch.size()) tell();
  return missing;
}

void PageFetcher::Worker::fetch(const std::vector<PageItem>& items) {
  grpc::ClientContext context;
  std::optional<Call> call;
  {
    const std::lock_guard lock(mutex_);
    if (is_stopping_) return;
    call = delivery_.begin(items, std::chrono::steady_clock::now());
    if (call) contexts_[*call] = &context;
  }
  if (call) end(*call, listen(*call, items, context));
}

Status PageFetcher::Worker::listen(Call call, const std::vector<PageItem>& items,
                                   grpc::ClientContext& context) {
  ASSIGN_OR_RETURN(const auto reached, reach());
  set_node(context, reached->server.node);
  return items.front().is_of_sheets() ? listen_for_sheets(call, items, context, *reached)
                                      : listen_for_pages(call, items, context, *reached);
}

Status PageFetcher::Worker::listen_for_pages(Call call, const std::vector<PageItem>& items,
                                             grpc::ClientContext& context, Reached& reached) {
  const Connection::PageTaker taker{
      .block =
          [&](PagePart part) {
            return on_part(call, PageItem::of_block(part.number), std::move(part.bytes));
          },
      .page =
          [&](PagePart part) {
            return on_part(call, PageItem::of_page(part.number), std::move(part.bytes));
          }};
  return fetch_parts(reached.server.address, *reached.library, context, pages_wish(scan_, items),
                     taker);
}

Status PageFetcher::Worker::listen_for_sheets(Call call, const std::vector<PageItem>& items,
                                              grpc::ClientContext& context, Reached& reached) {
  const SheetsWish wish = sheets_wish(scan_, items);
  const Connection::SheetTaker taker{
      .block =
          [&](PagePart part) {
            return on_part(call, PageItem::of_sheet_block(part.number, wish.version),
                           std::move(part.bytes));
          },
      .charts =
          [&](PagePart part) {
            return on_part(call, PageItem::of_charts(part.number, wish.version),
                           std::move(part.bytes));
          },
      .sheet =
          [&](SheetPart part) {
            const auto halving = static_cast<uint8_t>(part.number.halving);  // of those asked for
            return on_part(call, PageItem::of_sheet(part.number.page, halving, wish.version),
                           std::move(part.bytes));
          }};
  return fetch_sheet_parts(reached.server.address, *reached.library, context, wish, taker);
}

bool PageFetcher::Worker::on_part(Call call, PageItem item, std::vector<uint8_t> bytes) {
  const auto now = std::chrono::steady_clock::now();
  if (disk_) disk_->keep(item, bytes);
  bool goes_on;
  {
    const std::lock_guard lock(mutex_);
    goes_on = delivery_.on_part(call, item, std::move(bytes), now) && !is_stopping_;
  }
  tell();
  return goes_on;
}

void PageFetcher::Worker::end(Call call, const Status& why) {
  {
    const std::lock_guard lock(mutex_);
    contexts_.erase(call);
    if (why.code() == StatusCode::kUnavailable) reached_.reset();
    if (!delivery_.end(call, why) || is_stopping_) return;
  }
  changed_.notify_all();
  tell();
}

void PageFetcher::Worker::tell() const {
  if (on_news_) on_news_();
}

// A channel of its own: pages do not hold up frames. After a loss or a move another one connects at
// once, without gRPC's back-off, and with certificates as they are then.
Result<std::shared_ptr<PageFetcher::Worker::Reached>> PageFetcher::Worker::reach() {
  const ServerPlace server = route_->place();
  const std::lock_guard lock(mutex_);
  if (reached_ && reached_->server == server) return reached_;
  ASSIGN_OR_RETURN(const auto channel, make_channel(server.address, trust_, Sharing::kOwn));
  reached_ = std::make_shared<Reached>(Reached{server, v1::Library::NewStub(channel)});
  return reached_;
}

}  // namespace burnish
