#include "tests/system/fleet_history.h"

#include <algorithm>

#include "server/postgres/pg_connection.h"

namespace burnish {

void FleetHistory::sent(const std::string& edit) {
  const std::lock_guard lock(mutex_);
  times_[edit].sent = ++clock_;
}

void FleetHistory::acknowledged(const std::string& edit) {
  const std::lock_guard lock(mutex_);
  times_[edit].acknowledged = ++clock_;
}

size_t FleetHistory::acknowledged_edits() const {
  const std::lock_guard lock(mutex_);
  return static_cast<size_t>(
      std::ranges::count_if(times_, [](const auto& edit) { return edit.second.acknowledged > 0; }));
}

static int64_t count(PgConnection& database, const char* query) {
  return database.run({query, {}})->integer(0, 0);
}

static std::vector<std::string> recorded_edits(PgConnection& database) {
  const PgReply reply = database.run({"SELECT id FROM edits ORDER BY number", {}}).value();
  std::vector<std::string> ids;
  for (size_t row = 0; row < reply.rows(); ++row) ids.push_back(reply.bytes(row, 0));
  return ids;
}

// From the end: nothing may stand before an edit that was acknowledged before it was sent.
void FleetHistory::check_order(const std::vector<std::string>& recorded,
                               std::vector<std::string>& wrong) const {
  uint64_t first_acknowledged = UINT64_MAX;
  for (auto id = recorded.rbegin(); id != recorded.rend(); ++id) {
    const auto times = times_.find(*id);
    if (times == times_.end()) {
      wrong.push_back("nobody has sent edit " + *id);
      continue;
    }
    if (times->second.sent > first_acknowledged)
      wrong.push_back("edit " + *id + " is out of order");
    if (times->second.acknowledged > 0)
      first_acknowledged = std::min(first_acknowledged, times->second.acknowledged);
  }
}

std::vector<std::string> FleetHistory::violations(const PgAddress& address) const {
  PgConnection database = PgConnection::open(address, {}, "test").value();
  const std::vector<std::string> recorded = recorded_edits(database);
  const std::lock_guard lock(mutex_);
  std::map<std::string, int> times_there;
  for (const std::string& id : recorded) ++times_there[id];
  std::vector<std::string> wrong;
  for (const auto& [id, times] : times_) {
    const int there = times_there[id];
    if (there == 0 && times.acknowledged > 0) wrong.push_back("edit " + id + " is lost");
    if (there > 1) wrong.push_back("edit " + id + " is there " + std::to_string(there) + " times");
  }
  check_order(recorded, wrong);
  if (count(database,
            "SELECT count(*) FROM (SELECT number - row_number() OVER (ORDER BY number) AS gap"
            " FROM edits) AS gaps WHERE gap <> 0") > 0)
    wrong.emplace_back("the numbers have gaps");
  const int64_t falls =
      count(database,
            "SELECT count(*) FROM (SELECT epoch - lag(epoch) OVER (ORDER BY number) AS step"
            " FROM edits) AS steps WHERE step < 0");
  if (falls > 0)
    wrong.push_back("two owners wrote at once: the epoch falls " + std::to_string(falls) +
                    " times");
  if (count(database, "SELECT edits FROM sessions") != static_cast<int64_t>(recorded.size()))
    wrong.emplace_back("the session's row has another count");
  return wrong;
}

}  // namespace burnish
