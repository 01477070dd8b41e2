#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace burnish {

/// Each user's share of the kept sessions, in memory or not: those that they made, and the bytes
/// of their histories. Counts, and limits nothing. Thread-safe; a Part may outlive it.
class KeptShares {
 public:
  struct Share {
    uint64_t sessions = 0;
    uint64_t history_bytes = 0;
  };

 private:
  struct State {
    std::mutex mutex;
    std::map<std::string, Share> by_user;
  };

 public:
  /// One session's part of its maker's share. Gives it back at its end.
  class Part {
   public:
    Part() = default;
    Part(Part&& other) noexcept { *this = std::move(other); }
    Part& operator=(Part&& other) noexcept;
    ~Part();

    void set_history_bytes(uint64_t bytes);
    uint64_t history_bytes() const;
    const std::string& user() const { return user_; }

   private:
    friend class KeptShares;
    void give_back();

    std::shared_ptr<State> state_;  // null: moved away
    std::string user_;
    uint64_t bytes_ = 0;  // under the state's mutex
  };

  /// Counts a session for its maker; "" is nobody.
  Part add(const std::string& user, uint64_t history_bytes);

  Share of(const std::string& user) const;

  /// Returns the most sessions and the most bytes that one user has.
  Share largest() const;

 private:
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace burnish
