#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace burnish {

/// A mutex that is handed on in the order of the requests, so that somebody who works turn by turn
/// all the time keeps nobody out. A Ticket is a position in the line for somebody who must not
/// wait. Works with std::unique_lock.
class FairMutex {
 public:
  class Ticket;

  void lock();
  bool try_lock();
  void unlock();

  /// Waits while `go_on` returns true, and keeps its position in the line meanwhile. Calls `go_on`
  /// ten times a second, without the mutex. Returns false without the mutex if `go_on` returned
  /// false.
  bool lock_while(const std::function<bool()>& go_on);

  /// For a long holder, from time to time: a Ticket in the line has its turn now. Returns with the
  /// mutex held as before.
  void let_ticket_pass();

 private:
  struct Waiter {
    std::condition_variable wake;
    bool is_owner = false;
  };

  void hand_on(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;  // guards the following members
  bool held_ = false;
  bool last_was_ticket_ = false;
  Ticket* kept_for_ = nullptr;  // held_ is true, for this ticket to take
  std::list<Waiter> waiters_;   // the first has waited longest
  std::list<Ticket*> tickets_;  // likewise; waiters and tickets take turns
};

/// A position in the line for somebody who must not wait. Tickets and waiters take turns, so
/// neither keeps the other out. Used by one thread at a time; must end before its mutex.
class FairMutex::Ticket {
 public:
  /// `call` says that the mutex is kept for this ticket: call take() soon, or leave(). It comes
  /// from any thread, must be short and must not touch the mutex.
  Ticket(FairMutex& mutex, std::function<void()> call) : mutex_(mutex), call_(std::move(call)) {}
  ~Ticket() { leave(); }
  Ticket(const Ticket&) = delete;
  Ticket& operator=(const Ticket&) = delete;

  /// Returns true if the caller holds the mutex now, and must unlock it. Returns false if the
  /// ticket is in the line.
  bool take();

  /// Leaves the line. Hands on a mutex that was kept for this ticket.
  void leave();

 private:
  friend class FairMutex;
  FairMutex& mutex_;
  const std::function<void()> call_;
};

}  // namespace burnish
