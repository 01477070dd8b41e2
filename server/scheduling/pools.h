#pragma once

#include "server/scheduling/executor.h"

namespace burnish {

/// Says what a request's work waits for. Each pool has its own workers, so that no work waits for
/// slower work of another pool.
enum class Pool {
  kShort,    ///< memory and small files: lists, descriptions
  kSession,  ///< a session that others may use, or the disk: edits, state, chunks
  kLong,     ///< the solver, preparing, whole files: seconds to minutes
};

/// The workers of all requests.
class Pools {
 public:
  /// For kLong, and as many for kSession, whose workers mostly sleep.
  struct Limits {
    int workers = 16;
    int workers_per_user = 4;
    uint64_t requests_per_user = 1024;  ///< waiting requests, in each pool
    uint64_t request_bytes_per_user = uint64_t{64} << 20;
  };

  explicit Pools(const Limits& limits);

  Executor& operator[](Pool pool);

 private:
  Executor short_, session_, long_;
};

}  // namespace burnish
