#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "common/service/session_people.h"

namespace burnish {

/// The people in one session, in memory only. Thread-safe.
class Presence {
 public:
  /// Returns the connection's number. Gives it the least used colour.
  uint64_t join(const std::string& user);

  /// Does nothing for a connection that has left.
  void leave(uint64_t connection);
  void move_brush(uint64_t connection, const std::optional<BrushRing>& ring);

  std::vector<PresentUser> list() const;

  /// Returns a number that grows with every change, so that a watcher knows when to look again.
  uint64_t version() const;

 private:
  uint32_t free_colour() const;

  mutable std::mutex mutex_;
  std::map<uint64_t, PresentUser> present_;
  uint64_t last_connection_ = 0;
  uint64_t version_ = 0;
};

}  // namespace burnish
