#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/pages/fetch_queue.h"
#include "client/pages/link_meter.h"
#include "client/pages/page_source.h"

namespace burnish {

/// Limit of calls at the same time: one asks while the other one's pages are on the link.
inline constexpr int kFetchCallsMax = 2;

/// All of a PageSource but threads and calls: which call is to bring what, which calls are of no
/// use any more, and what has come. A driver carries the calls. Used from one thread at a time.
class PageDelivery {
 public:
  using Time = LinkMeter::Time;
  using Call = uint64_t;  ///< number of a call

  /// `server`: its address, for messages.
  explicit PageDelivery(std::string server) : server_(std::move(server)) {}

  void ask(std::span<const PageItem> items);
  /// Returns calls that bring nothing of use any more: they would hold up others. The driver
  /// cancels them, and tells by end() when they have ended.
  std::vector<Call> cancel(std::span<const PageItem> items);
  std::vector<PageSource::Arrival> take() { return std::exchange(arrivals_, {}); }
  LinkSpeed speed() const { return meter_.speed(); }

  /// Returns the items that the next call is to bring; empty: none.
  std::vector<PageItem> next_batch() { return queue_.take_batch(); }
  /// An item of a batch was found without a call. Returns whether somebody waits for it.
  bool on_found(PageItem item, std::vector<uint8_t> bytes);
  /// Begins the call for a batch, or for what is left of it. Nothing: nobody waits for it any more.
  std::optional<Call> begin(std::vector<PageItem> batch, Time now);
  /// A call has brought an item. Returns whether the call is still of use; if not, the driver
  /// cancels it.
  bool on_part(Call call, PageItem item, std::vector<uint8_t> bytes, Time now);
  /// A call has ended. Returns whether take() or next_batch() has something new.
  bool end(Call call, const Status& why);

 private:
  struct Running {
    std::vector<PageItem> items;
    size_t coming = 0;  // of the items
    Time began = {};
    bool has_begun = false;  // a part has come
    bool is_cancelled = false;
  };
  bool is_useful(const Running& call) const;
  bool settle(const std::vector<PageItem>& items, bool is_cancelled, const Status& why);

  const std::string server_;
  FetchQueue queue_;
  LinkMeter meter_;
  std::map<Call, Running> calls_;
  Call last_call_ = 0;
  std::vector<PageSource::Arrival> arrivals_;
};

}  // namespace burnish
