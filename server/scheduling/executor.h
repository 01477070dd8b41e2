#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Runs `work`. An exception ends only this work: it is logged, and `on_failure` (which may be
/// empty) gets resource_exhausted if memory ran out, else internal.
void run_guarded(const std::function<void()>& work,
                 const std::function<void(const Status&)>& on_failure);

/// A few threads for work that must not block a reaction of the service: disk, solver, journal.
///
/// Each piece of work belongs to a holder: a user, or an address. Holders take turns, longest
/// waiting first, so that one holder's waiting work holds up nobody else.
class Executor {
 public:
  struct Limits {
    static constexpr uint64_t kNone = std::numeric_limits<uint64_t>::max();
    int threads = 1;
    int threads_per_holder = std::numeric_limits<int>::max();
    uint64_t waiting_per_holder = kNone;  ///< pieces
    uint64_t bytes_per_holder = kNone;    ///< of waiting and running pieces
    uint64_t waiting_max = kNone;         ///< pieces of all holders together
    uint64_t bytes_max = kNone;
  };

  struct Piece {
    std::function<void()> work;
    /// Gets the reason if the work was not done or did not end, from any thread.
    std::function<void(const Status&)> on_failure = {};
    std::string holder = {};
    uint64_t bytes = 0;  ///< memory of the piece: its request
  };

  explicit Executor(const Limits& limits);
  /// One holder for everybody, without a limit.
  explicit Executor(int threads) : Executor(Limits{.threads = threads}) {}

  /// Runs all posted work, then ends.
  ~Executor();

  /// on_failure gets resource_exhausted "user anna has 1024 requests waiting, the limit is 1024",
  /// or the failures of run_guarded().
  void post(Piece piece);
  void post(std::function<void()> work) { post(Piece{std::move(work)}); }

 private:
  struct Holder {
    std::deque<Piece> waiting;
    uint64_t bytes = 0;
    int at_work = 0;
    bool in_turn = false;  // its name is in turns_
  };
  using Holders = std::map<std::string, Holder>;

  Status check_room(const Piece& piece) const;
  void take_ticket(Holders::value_type& holder);
  void run();

  const Limits limits_;
  std::mutex mutex_;
  std::condition_variable wake_;
  Holders holders_;                // holders with work
  std::deque<std::string> turns_;  // holders whose next piece may start, in order
  uint64_t waiting_ = 0;
  uint64_t bytes_ = 0;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace burnish
