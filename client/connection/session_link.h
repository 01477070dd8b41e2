#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "client/live/live_link.h"

namespace burnish {

/// A LiveLink by gRPC, with a thread of its own. Thread-safe.
class SessionLink final : public LiveLink {
 public:
  /// Begins to connect, by a connection of its own: what else is fetched does not hold up frames.
  SessionLink(const Connection& connection, LiveOptions options);
  /// See wait_until_acknowledged().
  ~SessionLink() override;

  Status apply(std::vector<Edit> edits) override;
  void preview(const std::string& edit_id, PreviewChange change) override;
  void drop_preview(const std::string& edit_id) override;
  void move_brush(const std::optional<BrushRing>& ring) override;
  Status show_pages(std::vector<std::shared_ptr<const Page>> added,
                    std::vector<PageId> removed) override;
  using LiveLink::take;
  LiveNews take(bool draws) override;
  void on_picture(std::chrono::microseconds took) override;

  /// Waits until no edit is under way. False when `patience` is over or the session has ended.
  bool wait_until_acknowledged(std::chrono::milliseconds patience);

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace burnish
