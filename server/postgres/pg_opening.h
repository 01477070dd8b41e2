#pragma once

#include <chrono>
#include <string>

#include "common/base/status.h"
#include "server/postgres/pg_address.h"

struct pg_conn;

namespace burnish {

/// Connects without blocking, to one host after the other; each has `time`. The caller finishes the
/// connection. Fails: unavailable with the reason of each host.
Result<pg_conn*> open_pg(const PgAddress& address, std::chrono::milliseconds time,
                         const std::string& application);

}  // namespace burnish
