#pragma once

#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace burnish {

/// A mutex that is handed on in the order in which it was asked for: whoever works at something
/// turn by turn, all the time, keeps nobody out. Whoever must not wait holds a Place in the line.
/// Works with std::unique_lock.
class FairMutex {
 public:
  class Place;

  void lock();
  bool try_lock();
  void unlock();

  /// Waits while `go_on` says so, and keeps its place in the line meanwhile. `go_on` is asked ten
  /// times a second, without the mutex. False: it said no, and the mutex is somebody else's.
  bool lock_while(const std::function<bool()>& go_on);

  /// For a long holder, from time to time: if there is a Place in the line, it has its turn now.
  /// Returns with the mutex held as before.
  void let_place_pass();

 private:
  struct Waiter {
    std::condition_variable wake;
    bool is_owner = false;
  };

  void hand_on(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;  // of what follows
  bool held_ = false;
  bool last_was_place_ = false;
  Place* kept_for_ = nullptr;  // held_, for this one to take
  std::list<Waiter> waiters_;  // the first one waits longest
  std::list<Place*> places_;   // likewise; waiters and places take turns
};

/// A place in the line for somebody who must not wait. Places and those who wait take turns, so
/// that neither keeps the other out. Used by one thread at a time; ends before its mutex.
class FairMutex::Place {
 public:
  /// `call` is called when the mutex is kept for this place: take() it soon, or leave(). It comes
  /// from any thread, must be short and must not touch the mutex.
  Place(FairMutex& mutex, std::function<void()> call) : mutex_(mutex), call_(std::move(call)) {}
  ~Place() { leave(); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// True: the caller holds the mutex now, and unlocks it. False: the place is in the line.
  bool take();

  /// Goes out of the line. A mutex that was kept for this place is handed on.
  void leave();

 private:
  friend class FairMutex;
  FairMutex& mutex_;
  const std::function<void()> call_;
};

}  // namespace burnish
