#pragma once

#include <string>

#include "server/journal/postgres_appends.h"

namespace burnish {

/// Returns the failure of a transaction, in the terms of a Journal.
Status status_of(const PgOutcome& outcome);

/// Says why this server does not hold a session.
Status who_holds(PgConnection& database, const std::string& session_id, const Holdings& holdings);

/// Does a change of a held session. Fails: as who_holds() if it changes no row.
Status change_held(PgConnection& database, const PgStatement& change, const std::string& session_id,
                   const Holdings& holdings);

}  // namespace burnish
