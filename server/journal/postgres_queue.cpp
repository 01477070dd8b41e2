#include "server/journal/postgres_queue.h"

#include <algorithm>
#include <future>

#include <spdlog/spdlog.h>

#include "server/journal/postgres_schema.h"
#include "server/metrics/metrics.h"

namespace burnish {

using std::chrono::steady_clock;

/// The dead node's connections are found by this name.
static std::string application_of(const std::string& life) {
  return life.empty() ? "burnish" : "burnish " + life;
}

Result<std::unique_ptr<PostgresQueue>> PostgresQueue::open(const PgAddress& address,
                                                           const PostgresPatience& patience) {
  ASSIGN_OR_RETURN(PgConnection connection,
                   PgConnection::open(address, patience.connection, application_of("")));
  RETURN_IF_ERROR(make_postgres_schema(connection));
  return std::unique_ptr<PostgresQueue>(
      new PostgresQueue(address, patience, std::move(connection)));
}

PostgresQueue::PostgresQueue(const PgAddress& address, const PostgresPatience& patience,
                             PgConnection connection)
    : address_(address),
      patience_(patience),
      connection_(std::move(connection)),
      thread_([this] { loop(); }) {}

PostgresQueue::~PostgresQueue() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void PostgresQueue::post(Item item) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(item));
  }
  wake_.notify_all();
}

void PostgresQueue::append(PendingAppend append) {
  post({.append = std::move(append), .work = {}, .done = {}});
}

Status PostgresQueue::run(const Work& work, Repeat repeat) {
  std::promise<Status> done;
  post({.append = {}, .work = work, .repeat = repeat, .done = [&](const Status& status) {
          done.set_value(status);
        }});
  return done.get_future().get();
}

void PostgresQueue::start(const Work& work) {
  const auto note = [](const Status& status) {
    if (!status.is_ok()) spdlog::warn("{}", status.message());
  };
  post({.append = {}, .work = work, .is_due_anyway = true, .done = note});
}

void PostgresQueue::loop() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || !queue_.empty(); });
      if (queue_.empty()) return;
    }
    if (auto appends = take_appends(); !appends.empty()) {
      write(std::move(appends));
      continue;
    }
    Item item;
    {
      const std::lock_guard lock(mutex_);
      item = std::move(queue_.front());
      queue_.pop_front();
    }
    item.done(do_work(item));
  }
}

/// Takes the appends at the front, at least one and not too many for one commit.
std::vector<PendingAppend> PostgresQueue::take_appends() {
  static constexpr size_t kEditsPerCommit = 256;
  std::vector<PendingAppend> appends;
  const std::lock_guard lock(mutex_);
  size_t edits = 0;
  while (!queue_.empty() && queue_.front().append) {
    edits += std::max<size_t>(1, queue_.front().append->edits.size());
    if (!appends.empty() && edits > kEditsPerCommit) break;
    appends.push_back(std::move(*queue_.front().append));
    queue_.pop_front();
  }
  return appends;
}

/// Tries until each append has an outcome, or the database has been away for too long.
void PostgresQueue::write(std::vector<PendingAppend> appends) {
  const auto begin = steady_clock::now();
  std::span<PendingAppend> open(appends);
  for (;;) {
    last_problem_ = connect();
    if (last_problem_.is_ok()) last_problem_ = write_appends(connection_, holdings_, open);
    const auto has_outcome = [](const PendingAppend& append) { return append.outcome.has_value(); };
    open = std::span(std::ranges::stable_partition(open, has_outcome));
    if (open.empty() || !wait_for_another_try(begin + patience_.away)) break;
  }
  ++commits_;
  if (open.empty())
    metrics().observe(Measure::kJournalCommitSeconds,
                      std::chrono::duration<double>(steady_clock::now() - begin).count());
  for (PendingAppend& append : open) append.outcome = WriteOutcome::unknown(last_problem_);
  for (const PendingAppend& append : appends) append.done(*append.outcome);
}

/// Returns false if it is too late for another try.
bool PostgresQueue::wait_for_another_try(steady_clock::time_point end) {
  static constexpr auto kPause = std::chrono::milliseconds(200);
  spdlog::warn("edits wait for the database: {}", last_problem_.message());
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, kPause, [this] { return ending_; });
  return !ending_ && steady_clock::now() < end;
}

Status PostgresQueue::connect() {
  if (connection_.is_open()) return Status::ok();
  ASSIGN_OR_RETURN(connection_, PgConnection::open(address_, patience_.connection,
                                                   application_of(holdings_.life)));
  return Status::ok();
}

Status PostgresQueue::do_work(const Item& item) {
  const bool was_open = connection_.is_open();
  const Status connected = connect();
  if (!connected.is_ok() && !item.is_due_anyway) return connected;
  const Status status = item.work(connection_, holdings_);
  const bool is_broken = !connection_.is_open();
  if (!is_broken || item.repeat == Repeat::kNever || !was_open) return status;
  RETURN_IF_ERROR(connect());
  return item.work(connection_, holdings_);
}

}  // namespace burnish
