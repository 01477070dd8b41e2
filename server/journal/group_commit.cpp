#include "server/journal/group_commit.h"

#include <algorithm>
#include <future>

namespace burnish {

GroupCommit::GroupCommit(Database database)
    : database_(std::move(database)), thread_([this] { run(); }) {}

GroupCommit::~GroupCommit() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void GroupCommit::enqueue(Item item) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(item));
  }
  wake_.notify_one();
}

void GroupCommit::post(Work work, Done done) {
  enqueue({std::move(work), std::move(done), false, {}});
}

void GroupCommit::post_background(Work work, Done done) {
  enqueue({std::move(work), std::move(done), true, {}});
}

Status GroupCommit::write(const Work& work) {
  std::promise<Status> written;
  post(work, [&](const WriteOutcome& outcome) { written.set_value(outcome.status()); });
  return written.get_future().get();
}

Status GroupCommit::read(const Work& work) {
  std::promise<void> reached;  // from background work: after all work posted before
  post_background([](Database&) { return Status::ok(); },
                  [&](const WriteOutcome&) { reached.set_value(); });
  reached.get_future().get();
  const std::lock_guard lock(database_mutex_);
  return work(database_);
}

void GroupCommit::run() {
  for (;;) {
    std::vector<Item> items;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || !queue_.empty(); });
      if (queue_.empty()) return;
      items = std::exchange(queue_, {});
    }
    const auto background = std::stable_partition(
        items.begin(), items.end(), [](const Item& item) { return !item.is_background; });
    for (const std::span<Item> part :
         {std::span(items.begin(), background), std::span(background, items.end())}) {
      if (part.empty()) continue;
      commit(part);
      for (const Item& item : part) item.done(item.outcome);
    }
  }
}

void GroupCommit::commit(std::span<Item> items) {
  WriteOutcome outcome;
  {
    const std::lock_guard lock(database_mutex_);
    outcome = commit_all(items);
  }
  ++commits_;
  if (outcome.is_on_disk()) return;
  // One large item may have filled the disk. The others may fit without it.
  if (outcome.status().code() == StatusCode::kResourceExhausted && items.size() > 1) {
    for (Item& item : items) commit({&item, 1});
    return;
  }
  for (Item& item : items)
    if (item.outcome.is_on_disk()) item.outcome = outcome;
}

/// Sets the outcomes of the items that fail by themselves, and returns that of the others.
WriteOutcome GroupCommit::commit_all(std::span<Item> items) {
  auto transaction = Transaction::begin(database_);
  if (!transaction.is_ok()) return WriteOutcome::refused(transaction.status());
  for (Item& item : items) {
    const Status status = work_alone(item);
    if (!status.is_ok()) return WriteOutcome::refused(status);
  }
  return transaction->commit();
}

/// Does the item's work whole or not at all. Fails if the transaction cannot go on.
Status GroupCommit::work_alone(Item& item) {
  RETURN_IF_ERROR(database_.execute("SAVEPOINT item"));
  const Status status = item.work(database_);
  item.outcome = WriteOutcome::of(status);
  // After some errors, such as a full disk, SQLite has rolled back everything by itself.
  if (!status.is_ok() && !database_.execute("ROLLBACK TO item").is_ok()) return status;
  return database_.execute("RELEASE item");
}

}  // namespace burnish
