#include "server/session/group_commit.h"

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

void GroupCommit::post(Work work, Done done) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back({std::move(work), std::move(done), {}});
  }
  wake_.notify_one();
}

Status GroupCommit::write(const Work& work) {
  std::promise<Status> written;
  post(work, [&](const Status& status) { written.set_value(status); });
  return written.get_future().get();
}

Status GroupCommit::read(const Work& work) {
  (void)write([](Database&) { return Status::ok(); });
  const std::lock_guard lock(database_mutex_);
  return work(database_);
}

void GroupCommit::run() {
  for (;;) {
    std::deque<Item> items;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || !queue_.empty(); });
      if (queue_.empty()) return;
      items = std::exchange(queue_, {});
    }
    commit(items);
    for (const Item& item : items) item.done(item.status);
  }
}

void GroupCommit::commit(std::deque<Item>& items) {
  const std::lock_guard lock(database_mutex_);
  const Status status = commit_all(items);
  ++commits_;
  if (status.is_ok()) return;
  for (Item& item : items)
    if (item.status.is_ok()) item.status = status;
}

Status GroupCommit::commit_all(std::deque<Item>& items) {
  ASSIGN_OR_RETURN(Transaction transaction, Transaction::begin(database_));
  for (Item& item : items) {
    RETURN_IF_ERROR(database_.execute("SAVEPOINT item"));
    item.status = item.work(database_);
    // After some errors, a full disk among them, SQLite has rolled everything back by itself.
    if (!item.status.is_ok() && !database_.execute("ROLLBACK TO item").is_ok()) return item.status;
    RETURN_IF_ERROR(database_.execute("RELEASE item"));
  }
  return transaction.commit();
}

}  // namespace burnish
