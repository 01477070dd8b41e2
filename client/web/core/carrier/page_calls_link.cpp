#include "client/web/core/carrier/page_calls_link.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "client/connection/connection_state.h"
#include "common/wire/pages_wire.h"

namespace burnish {

using std::chrono::steady_clock;

PageCallsLink::PageCallsLink(std::shared_ptr<ServerRoute> route, FetchedPages pages)
    : route_(std::move(route)),
      scan_(std::move(pages.scan)),
      on_news_(std::move(pages.on_news)),
      delivery_(route_->address()) {}

void PageCallsLink::ask(std::span<const PageItem> items) {
  delivery_.ask(items);
  fetch();
}

void PageCallsLink::cancel(std::span<const PageItem> items) {
  for (const Call call : delivery_.cancel(items)) running_.at(call).call->cancel();
}

// Begins as many calls as may run.
void PageCallsLink::fetch() {
  const auto is_running = [](const auto& each) { return !each.second.has_ended; };
  while (std::ranges::count_if(running_, is_running) < kFetchCallsMax) {
    std::vector<PageItem> batch = delivery_.next_batch();
    if (batch.empty()) return;
    begin(std::move(batch));
  }
}

void PageCallsLink::begin(std::vector<PageItem> batch) {
  PagesWish wish{.scan = scan_, .blocks = {}, .pages = {}};
  for (const PageItem item : batch)
    (item.kind == PageItem::Kind::kPage ? wish.pages : wish.blocks).push_back(item.number);
  const auto number = delivery_.begin(std::move(batch), steady_clock::now());
  if (!number) return;
  auto call = std::make_unique<HostCall>("burnish.v1.Library/FetchPages", route_->place().node,
                                         [this, call = *number] { listen(call); });
  call->send(to_wire(wish).SerializeAsString());
  call->end_sending();
  running_[*number].call = std::move(call);
}

void PageCallsLink::listen(Call number) {
  Running& running = running_.at(number);
  while (const auto message = running.call->take()) take_message(number, running, *message);
  if (const auto& end = running.call->end(); end && !running.has_ended) {
    running.has_ended = true;
    const Status there = call_status(route_->address(), {end->code, end->message});
    delivery_.end(number, running.damage.is_ok() ? there : running.damage);
    fetch();
  }
  on_news_();
}

void PageCallsLink::take_message(Call number, Running& running, const std::vector<uint8_t>& bytes) {
  v1::FetchPagesEvent event;
  if (!event.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
    running.damage = data_loss("server " + route_->address() + ": a message with pages is damaged");
    return running.call->cancel();
  }
  if (!event.has_block() && !event.has_page()) return;
  PagePart part = from_wire(event.has_block() ? event.block() : event.page());
  const PageItem item =
      event.has_block() ? PageItem::of_block(part.number) : PageItem::of_page(part.number);
  if (!delivery_.on_part(number, item, std::move(part.bytes), steady_clock::now()))
    running.call->cancel();
}

PageCallsLink::Time PageCallsLink::on_time(Time) {
  std::erase_if(running_, [](const auto& each) { return each.second.has_ended; });
  return Time::max();
}

}  // namespace burnish
