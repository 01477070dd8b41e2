#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/connection/page_disk.h"
#include "client/pages/page_item.h"
#include "client/pages/page_requests.h"
#include "common/base/status.h"

namespace burnish {

/// Brings encoded pages and directory blocks of a scan, from the disk or from the server. It has
/// threads and a channel of its own, and at most two calls under way. No call waits for the
/// network or the disk. Thread-safe.
class PageFetcher {
 public:
  struct Arrival {
    PageItem item;
    Result<std::vector<uint8_t>> bytes;  ///< not checked
  };

  /// `on_news` is called from a thread of the fetcher's own when there is something to take. Must
  /// not block. `disk` may be null.
  PageFetcher(const Connection& connection, std::string scan, std::function<void()> on_news,
              std::shared_ptr<PageDisk> disk = nullptr);
  /// Cancels what is under way.
  ~PageFetcher();

  /// Asks for items, the most urgent first, behind those that are asked for already. Each arrives
  /// once, or fails: as the server says, data_loss (the server left it out). Once the connection is
  /// lost all fail with unavailable. Needs: items that the scan has.
  void ask(std::span<const PageItem> items);
  /// The items do not arrive any more.
  void cancel(std::span<const PageItem> items);

  /// Returns what has come since the last call.
  std::vector<Arrival> take();

  /// Returns what the last calls have measured: bytes per second, and the time to the first part.
  LinkSpeed speed() const;

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace burnish
