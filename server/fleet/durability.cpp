#include "server/fleet/durability.h"

namespace burnish {

// A user who may not see a standby's row still sees that it is there.
static constexpr char kSettings[] =
    "SELECT current_setting('synchronous_standby_names'), current_setting('synchronous_commit'),"
    " (SELECT count(*) FROM pg_stat_replication), current_setting('fsync'),"
    " current_setting('full_page_writes')";

Result<std::vector<std::string>> durability_warnings(PgConnection& database, bool wants_replicas) {
  ASSIGN_OR_RETURN(const PgReply settings, database.run({kSettings, {}}));
  const bool names_standby = !settings.bytes(0, 0).empty();
  const std::string commit = settings.bytes(0, 1);
  const int64_t standbys = settings.integer(0, 2);
  std::vector<std::string> warnings;
  if (!names_standby && wants_replicas)
    warnings.emplace_back(
        "fleet.durability is \"replicated\", but synchronous_standby_names is empty: edits are "
        "acknowledged when one machine has them");
  if (!names_standby && !wants_replicas && standbys > 0)
    warnings.push_back("the database has " + std::to_string(standbys) +
                       " standbys and synchronous_standby_names is empty: a failover loses edits "
                       "that were acknowledged");
  if (names_standby && commit == "local")
    warnings.emplace_back(
        "synchronous_commit is \"local\": edits are acknowledged before the standby has them");
  for (const int column : {3, 4})
    if (settings.bytes(0, static_cast<size_t>(column)) == "off")
      warnings.push_back(std::string(column == 3 ? "fsync" : "full_page_writes") +
                         " is off: a power cut loses edits that were acknowledged");
  return warnings;
}

}  // namespace burnish
