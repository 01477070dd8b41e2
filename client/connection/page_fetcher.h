#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/connection/page_disk.h"
#include "client/pages/page_source.h"

namespace burnish {

/// A PageSource that looks on the disk, and then asks the server. It has threads and a channel of
/// its own. No call waits for the network or the disk. Thread-safe.
class PageFetcher final : public PageSource {
 public:
  /// `on_news` is called from a thread of the fetcher's own when there is something to take. Must
  /// not block. `disk` may be null.
  PageFetcher(const Connection& connection, std::string scan, std::function<void()> on_news,
              std::shared_ptr<PageDisk> disk = nullptr);
  ~PageFetcher() override;

  void ask(std::span<const PageItem> items) override;
  void cancel(std::span<const PageItem> items) override;
  std::vector<Arrival> take() override;
  LinkSpeed speed() const override;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace burnish
