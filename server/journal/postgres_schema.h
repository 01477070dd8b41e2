#pragma once

#include "server/postgres/pg_connection.h"

namespace burnish {

/// Makes the tables of a new journal, or updates those of an older program, in one transaction
/// under a lock: several servers may start at once. A journal of the next program is taken as it
/// is, because its schema only adds. Fails: data_loss for a journal of a newer program;
/// unavailable.
Status make_postgres_schema(PgConnection& database);

}  // namespace burnish
