#include "client/connection/page_fetcher.h"

#include "client/connection/connection_state.h"
#include "client/connection/page_fetch_worker.h"

namespace burnish {

PageFetcher::PageFetcher(const Connection& connection, std::string scan,
                         std::function<void()> on_news, std::shared_ptr<PageDisk> disk)
    : worker_(std::make_unique<Worker>(connection.state_->route, connection.state_->trust,
                                       std::move(scan), std::move(on_news), std::move(disk))) {}

PageFetcher::~PageFetcher() = default;

void PageFetcher::ask(std::span<const PageItem> items) {
  worker_->ask(items);
}

void PageFetcher::cancel(std::span<const PageItem> items) {
  worker_->cancel(items);
}

std::vector<PageSource::Arrival> PageFetcher::take() {
  return worker_->take();
}

LinkSpeed PageFetcher::speed() const {
  return worker_->speed();
}

}  // namespace burnish
