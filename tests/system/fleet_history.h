#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "server/postgres/pg_address.h"

namespace burnish {

/// What clients of the one session of a journal know of their edits: when each was first sent, and
/// acknowledged, by one counter for all clients. Thread-safe.
class FleetHistory {
 public:
  void sent(const std::string& edit);
  void acknowledged(const std::string& edit);

  /// Returns the number of acknowledged edits.
  size_t acknowledged_edits() const;

  /// Compares with the journal of the database. Returns what is wrong, in words: an acknowledged
  /// edit is missing ("lost") or there twice, an edit stands before one that was acknowledged
  /// before it was sent ("out of order"), numbers have gaps, epochs fall ("two owners"), or the
  /// count in the session's row is another one. Needs: no client edits.
  std::vector<std::string> violations(const PgAddress& database) const;

 private:
  struct Times {
    uint64_t sent = 0, acknowledged = 0;  ///< 0: not yet
  };
  void check_order(const std::vector<std::string>& recorded, std::vector<std::string>& wrong) const;

  mutable std::mutex mutex_;
  std::map<std::string, Times> times_;
  uint64_t clock_ = 0;
};

}  // namespace burnish
