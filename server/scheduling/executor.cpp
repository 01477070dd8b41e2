#include "server/scheduling/executor.h"

#include <exception>
#include <new>
#include <utility>

#include <spdlog/spdlog.h>

#include "server/process/log_context.h"

namespace burnish {

static Status status_of_exception() try { throw; } catch (const std::bad_alloc&) {
  return resource_exhausted("the server does not have enough memory for this request");
} catch (const std::exception& error) {
  return internal_error(std::string("the request failed unexpectedly: ") + error.what());
} catch (...) {
  return internal_error("the request failed unexpectedly");
}

void run_guarded(const std::function<void()>& work,
                 const std::function<void(const Status&)>& on_failure) {
  try {
    work();
    return;
  } catch (...) {
    try {
      const Status status = status_of_exception();
      spdlog::error("a request's work threw: {}", status.message());
      if (on_failure) on_failure(status);
    } catch (...) {  // no memory even for the message: the client's deadline ends the call
    }
  }
}

Executor::Executor(const Limits& limits) : limits_(limits) {
  for (int i = 0; i < limits.threads; ++i) threads_.emplace_back([this] { run(); });
}

Executor::~Executor() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

static Status too_much(const std::string& what, uint64_t max) {
  return resource_exhausted(what + ", the limit is " + std::to_string(max));
}

static std::string bytes_held(const std::string& whose, uint64_t held, uint64_t more) {
  return "requests of " + whose + " hold " + std::to_string(held) + " bytes and this one needs " +
         std::to_string(more) + " more";
}

Status Executor::check_room(const Piece& piece) const {
  const auto found = holders_.find(piece.holder);
  const uint64_t held = found == holders_.end() ? 0 : found->second.bytes;
  const uint64_t waiting = found == holders_.end() ? 0 : found->second.waiting.size();
  if (waiting >= limits_.waiting_per_holder)
    return too_much(piece.holder + " has " + std::to_string(waiting) + " requests waiting",
                    limits_.waiting_per_holder);
  if (piece.bytes > limits_.bytes_per_holder - held)
    return too_much(bytes_held(piece.holder, held, piece.bytes), limits_.bytes_per_holder);
  if (waiting_ >= limits_.waiting_max)
    return too_much("the server has " + std::to_string(waiting_) + " requests waiting",
                    limits_.waiting_max);
  if (piece.bytes > limits_.bytes_max - bytes_)
    return too_much(bytes_held("all users", bytes_, piece.bytes), limits_.bytes_max);
  return Status::ok();
}

void Executor::take_ticket(Holders::value_type& holder) {
  Holder& own = holder.second;
  if (own.in_turn || own.waiting.empty() || own.at_work >= limits_.threads_per_holder) return;
  own.in_turn = true;
  turns_.push_back(holder.first);
  wake_.notify_one();
}

void Executor::post(Piece piece) {
  // The work belongs to the request that posts it.
  piece.work = [plain = std::move(piece.work), request = LogContext::current()] {
    const LogContext context(request);
    plain();
  };
  std::unique_lock lock(mutex_);
  const Status room = check_room(piece);
  if (!room.is_ok()) {
    lock.unlock();
    if (piece.on_failure) piece.on_failure(room);
    return;
  }
  auto& holder = *holders_.try_emplace(piece.holder).first;
  holder.second.bytes += piece.bytes;
  bytes_ += piece.bytes;
  ++waiting_;
  holder.second.waiting.push_back(std::move(piece));
  take_ticket(holder);
}

void Executor::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return !turns_.empty() || (ending_ && waiting_ == 0); });
    if (turns_.empty()) return;
    const auto holder = holders_.find(turns_.front());
    Holder& own = holder->second;
    turns_.pop_front();
    own.in_turn = false;
    Piece piece = std::move(own.waiting.front());
    own.waiting.pop_front();
    ++own.at_work;
    if (--waiting_ == 0 && ending_) wake_.notify_all();
    take_ticket(*holder);

    lock.unlock();
    run_guarded(piece.work, piece.on_failure);
    const uint64_t bytes = piece.bytes;
    piece = {};  // frees its data without the lock
    lock.lock();

    --own.at_work;
    own.bytes -= bytes;
    bytes_ -= bytes;
    take_ticket(*holder);
    if (own.at_work == 0 && own.waiting.empty()) holders_.erase(holder);
  }
}

}  // namespace burnish
