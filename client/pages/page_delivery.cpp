#include "client/pages/page_delivery.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burnish {

static std::string name_of_item(PageItem item) {
  static constexpr const char* kNames[] = {"block ", "page ", "block of sheets ", "charts of page ",
                                           "sheet of page "};  // as Kind
  return kNames[static_cast<size_t>(item.kind)] + std::to_string(item.number);
}

void PageDelivery::ask(std::span<const PageItem> items) {
  for (const PageItem item : items) queue_.ask(item);
}

std::vector<PageDelivery::Call> PageDelivery::cancel(std::span<const PageItem> items) {
  for (const PageItem item : items) queue_.cancel(item);
  std::vector<Call> useless;
  for (auto& [number, call] : calls_)
    if (!is_useful(call) && !std::exchange(call.is_cancelled, true)) useless.push_back(number);
  return useless;
}

// A call that has brought all ends by itself.
bool PageDelivery::is_useful(const Running& call) const {
  return call.coming == 0 ||
         std::ranges::any_of(call.items, [&](PageItem item) { return queue_.is_open(item); });
}

bool PageDelivery::on_found(PageItem item, std::vector<uint8_t> bytes) {
  const bool is_wanted = queue_.arrive(item, bytes.size());
  if (is_wanted) arrivals_.push_back({item, std::move(bytes)});
  return is_wanted;
}

std::optional<PageDelivery::Call> PageDelivery::begin(std::vector<PageItem> batch, Time now) {
  Running call;
  call.coming = batch.size();
  call.items = std::move(batch);
  call.began = now;
  if (!is_useful(call)) {
    settle(call.items, true, Status::ok());
    return std::nullopt;
  }
  calls_.emplace(++last_call_, std::move(call));
  return last_call_;
}

bool PageDelivery::on_part(Call number, PageItem item, std::vector<uint8_t> bytes, Time now) {
  Running& call = calls_.at(number);
  meter_.on_part(bytes.size(), now);
  if (!std::exchange(call.has_begun, true)) meter_.on_first_part(call.began, now);
  on_found(item, std::move(bytes));
  if (call.coming > 0) --call.coming;
  if (is_useful(call)) return true;
  call.is_cancelled = true;
  return false;
}

bool PageDelivery::end(Call number, const Status& why) {
  const Running call = std::move(calls_.extract(number).mapped());
  if (call.has_begun) meter_.on_end();
  return settle(call.items, call.is_cancelled, why);
}

// Items that were asked for again after the call was cancelled wait for another call. Once the
// connection is lost, all that wait fail.
bool PageDelivery::settle(const std::vector<PageItem>& items, bool is_cancelled,
                          const Status& why) {
  std::vector<PageItem> left = queue_.end(items);
  if (why.code() == StatusCode::kUnavailable)
    std::ranges::copy(queue_.give_up_waiting(), std::back_inserter(left));
  for (const PageItem item : left) {
    if (is_cancelled)
      queue_.ask(item);
    else if (why.is_ok())
      arrivals_.push_back(
          {item, data_loss("server " + server_ + " left out " + name_of_item(item))});
    else
      arrivals_.push_back({item, why});
  }
  return !left.empty();
}

}  // namespace burnish
