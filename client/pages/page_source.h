#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "client/pages/page_item.h"
#include "client/pages/page_requests.h"
#include "common/base/status.h"

namespace burnish {

/// Brings encoded pages and directory blocks of a scan. No call waits.
class PageSource {
 public:
  struct Arrival {
    PageItem item;
    Result<std::vector<uint8_t>> bytes;  ///< not checked
  };

  PageSource() = default;
  /// Cancels what is under way.
  virtual ~PageSource() = default;
  PageSource(const PageSource&) = delete;
  PageSource& operator=(const PageSource&) = delete;

  /// Asks for items, the most urgent first, behind those that are asked for already. Each arrives
  /// once, or fails: as the server says, data_loss (the server left it out). Once the connection is
  /// lost all fail with unavailable. Needs: items that the scan has.
  virtual void ask(std::span<const PageItem> items) = 0;
  /// The items do not arrive any more.
  virtual void cancel(std::span<const PageItem> items) = 0;

  /// Returns what has come since the last call.
  virtual std::vector<Arrival> take() = 0;

  /// Returns what the last calls have measured: bytes per second, and the time to the first part.
  virtual LinkSpeed speed() const = 0;
};

}  // namespace burnish
