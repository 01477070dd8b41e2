#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// The holder of amounts that belong to no user.
inline constexpr const char* kServer = "the server";

/// Limits the amount that each holder may have at once. The Share gives its amount back when it
/// ends. Thread-safe; shares may outlive their quota.
class Quota {
 private:
  struct State;

 public:
  /// The amount of one holder.
  class Share {
   public:
    Share() = default;
    Share(Share&& other) noexcept;
    Share& operator=(Share&& other) noexcept;
    ~Share();

    uint64_t amount() const { return amount_; }

    /// Takes more, or gives some back. Needs: a share from take(). Fails: as take(), and is then
    /// unchanged.
    Status resize(uint64_t amount);

   private:
    friend class Quota;
    Share(std::shared_ptr<State> state, std::string holder, uint64_t amount)
        : state_(std::move(state)), holder_(std::move(holder)), amount_(amount) {}
    void give_back();

    std::shared_ptr<State> state_;  // null for an amount of zero
    std::string holder_;
    uint64_t amount_ = 0;
  };

  /// `what` and `key` are for messages: "streams", "limits.streams_per_user".
  Quota(std::string what, std::string key, uint64_t max);

  /// Fails: resource_exhausted "user anna has 8 streams and needs 1 more;
  /// limits.streams_per_user is 8".
  Result<Share> take(const std::string& holder, uint64_t amount);

  /// Amounts of all holders together.
  uint64_t taken() const;
  uint64_t max() const;

 private:
  std::shared_ptr<State> state_;
};

}  // namespace burnish
