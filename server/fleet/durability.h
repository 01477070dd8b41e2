#pragma once

#include <string>
#include <vector>

#include "server/postgres/pg_connection.h"

namespace burnish {

/// Returns, in words for the log, what the database's settings may cost: edits that were
/// acknowledged and are gone after a power cut or a failover. `wants_replicas`: acknowledged edits
/// are to be on two machines. Fails: as the connection.
Result<std::vector<std::string>> durability_warnings(PgConnection& database, bool wants_replicas);

}  // namespace burnish
