#include "client/web/core/transport/page_calls_link.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "client/connection/connection_state.h"
#include "client/pages/fetch_wishes.h"
#include "common/wire/pages_wire.h"
#include "common/wire/sheets_wire.h"

namespace burnish {

using std::chrono::steady_clock;

namespace {

struct Part {
  PageItem item;
  std::vector<uint8_t> bytes;
};

std::optional<Part> part_of(const v1::FetchPagesEvent& event) {
  if (!event.has_block() && !event.has_page()) return std::nullopt;
  PagePart part = from_wire(event.has_block() ? event.block() : event.page());
  return Part{event.has_block() ? PageItem::of_block(part.number) : PageItem::of_page(part.number),
              std::move(part.bytes)};
}

std::optional<Part> part_of(const v1::FetchSheetsEvent& event) {
  if (event.has_sheet()) {
    SheetPart part = from_wire(event.sheet());
    const auto halving = static_cast<uint8_t>(part.number.halving);  // of those asked for
    return Part{PageItem::of_sheet(part.number.page, halving), std::move(part.bytes)};
  }
  if (!event.has_block() && !event.has_charts()) return std::nullopt;
  PagePart part = from_wire(event.has_block() ? event.block() : event.charts());
  return Part{
      event.has_block() ? PageItem::of_sheet_block(part.number) : PageItem::of_charts(part.number),
      std::move(part.bytes)};
}

/// Returns nothing where the message brings no part.
template <typename Event>
Result<std::optional<Part>> part_in(const std::vector<uint8_t>& bytes) {
  Event event;
  if (!event.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return data_loss("a message with pages is damaged");
  return part_of(event);
}

}  // namespace

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
  const bool is_of_sheets = batch.front().is_of_sheets();
  const uint64_t version = batch.front().version;
  const std::string wish = is_of_sheets ? to_wire(sheets_wish(scan_, batch)).SerializeAsString()
                                        : to_wire(pages_wish(scan_, batch)).SerializeAsString();
  const auto number = delivery_.begin(std::move(batch), steady_clock::now());
  if (!number) return;
  auto call = std::make_unique<HostCall>(
      is_of_sheets ? "burnish.v1.Library/FetchSheets" : "burnish.v1.Library/FetchPages",
      route_->place().node, [this, call = *number] { listen(call); });
  call->send(wish);
  call->end_sending();
  running_[*number] = {std::move(call), is_of_sheets, version, Status::ok(), false};
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
  auto part = running.is_of_sheets ? part_in<v1::FetchSheetsEvent>(bytes)
                                   : part_in<v1::FetchPagesEvent>(bytes);
  if (!part.is_ok()) {
    running.damage = part.status().with_context("server " + route_->address());
    return running.call->cancel();
  }
  if (!part->has_value()) return;
  auto& [item, content] = **part;
  item.version = running.version;
  if (!delivery_.on_part(number, item, std::move(content), steady_clock::now()))
    running.call->cancel();
}

PageCallsLink::Time PageCallsLink::on_time(Time) {
  std::erase_if(running_, [](const auto& each) { return each.second.has_ended; });
  return Time::max();
}

}  // namespace burnish
