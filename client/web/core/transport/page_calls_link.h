#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/connection/links.h"
#include "client/pages/page_delivery.h"
#include "client/pages/page_source.h"
#include "client/web/core/host/calls.h"
#include "client/web/core/host/clockwork.h"

namespace burnish {

/// A PageSource over the worker's calls, without threads.
class PageCallsLink final : public PageSource, public Clockwork {
 public:
  PageCallsLink(std::shared_ptr<ServerRoute> route, FetchedPages pages);

  void ask(std::span<const PageItem> items) override;
  void cancel(std::span<const PageItem> items) override;
  std::vector<Arrival> take() override { return delivery_.take(); }
  LinkSpeed speed() const override { return delivery_.speed(); }

  /// Ended calls are forgotten here: an event does not destroy the call that tells it.
  Time on_time(Time now) override;

 private:
  using Call = PageDelivery::Call;
  struct Running {
    std::unique_ptr<HostCall> call;
    bool is_of_sheets = false;
    uint64_t version = 0;  ///< of the sheets
    Status damage;         ///< of a message
    bool has_ended = false;
  };

  void fetch();
  void begin(std::vector<PageItem> batch);
  void listen(Call number);
  void take_message(Call number, Running& running, const std::vector<uint8_t>& bytes);

  const std::shared_ptr<ServerRoute> route_;
  const std::string scan_;
  const std::function<void()> on_news_;
  PageDelivery delivery_;
  std::map<Call, Running> running_;
};

}  // namespace burnish
