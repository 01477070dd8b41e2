#include "server/scheduling/pools.h"

#include <algorithm>

namespace burnish {

static constexpr int kShortWorkers = 4;
static constexpr int kShortWorkersPerUser = 2;
/// All users together may take the limits of this many users.
static constexpr uint64_t kFullUsersMax = 8;

static Executor::Limits limits_of(const Pools::Limits& limits, int workers, int per_user) {
  return {.threads = workers,
          .threads_per_holder = std::min(workers, per_user),
          .waiting_per_holder = limits.requests_per_user,
          .bytes_per_holder = limits.request_bytes_per_user,
          .waiting_max = limits.requests_per_user * kFullUsersMax,
          .bytes_max = limits.request_bytes_per_user * kFullUsersMax};
}

Pools::Pools(const Limits& limits)
    : short_(limits_of(limits, kShortWorkers, kShortWorkersPerUser)),
      session_(limits_of(limits, limits.workers, limits.workers_per_user)),
      long_(limits_of(limits, limits.workers, limits.workers_per_user)) {}

Executor& Pools::operator[](Pool pool) {
  switch (pool) {
    case Pool::kShort:
      return short_;
    case Pool::kSession:
      return session_;
    case Pool::kLong:
      break;
  }
  return long_;
}

}  // namespace burnish
