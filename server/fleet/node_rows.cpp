#include "server/fleet/node_rows.h"

#include <cstdio>
#include <random>

namespace burnish {

std::string new_life() {
  std::random_device random;
  char text[37];
  std::snprintf(text, sizeof text, "%08x-%04x-4%03x-a%03x-%08x%04x", random(), random() & 0xffff,
                random() & 0xfff, random() & 0xfff, random(), random() & 0xffff);
  return text;
}

// A stopped server may hold locks in an open transaction. Its connections have its life's name.
static constexpr char kCutConnections[] =
    "SELECT pg_terminate_backend(pid) FROM pg_stat_activity, nodes"
    " WHERE application_name = 'burnish ' || CAST(id AS text) AND ";

static constexpr char kEnter[] =
    "INSERT INTO nodes (id, name, address, lease_until) VALUES (CAST($1 AS uuid), $2, $3,"
    " clock_timestamp() + $4 * interval '1 millisecond') ON CONFLICT (name) DO NOTHING";

static PgStatement enter(const NodeFacts& node, const std::string& life,
                         std::chrono::milliseconds lease) {
  return {kEnter, {PgText{life}, PgText{node.name}, PgText{node.address}, int64_t{lease.count()}}};
}

// A life whose lease lives and that has a connection runs. One that was killed has none.
static constexpr char kEnds[] =
    "name = $1 AND (lease_until < clock_timestamp() OR NOT EXISTS (SELECT FROM pg_stat_activity"
    " WHERE application_name = 'burnish ' || CAST(nodes.id AS text)))";

std::vector<PgStatement> enter_life(const NodeFacts& node, const std::string& life,
                                    std::chrono::milliseconds lease) {
  return {{std::string(kCutConnections) + "name = $1 AND lease_until < clock_timestamp()",
           {PgText{node.name}}},
          {std::string("DELETE FROM nodes WHERE ") + kEnds, {PgText{node.name}}},
          enter(node, life, lease)};
}

std::vector<PgStatement> enter_life_of_free_name(const NodeFacts& node, const std::string& life,
                                                 std::chrono::milliseconds lease,
                                                 const NodeLoad& load) {
  return {{"DELETE FROM nodes WHERE name = $1 AND lease_until < clock_timestamp()",
           {PgText{node.name}}},
          enter(node, life, lease),
          renew_lease(life, lease, load)};
}

PgStatement renew_lease(const std::string& life, std::chrono::milliseconds lease,
                        const NodeLoad& load) {
  return {
      "UPDATE nodes SET lease_until = clock_timestamp() + $2 * interval '1 millisecond',"
      " backend = $3, bytes_max = $4, bytes_taken = $5, sessions = $6, draining = $7 <> 0"
      " WHERE id = CAST($1 AS uuid)",
      {PgText{life}, int64_t{lease.count()}, PgText{load.backend},
       static_cast<int64_t>(load.bytes_max), static_cast<int64_t>(load.bytes_taken),
       static_cast<int64_t>(load.sessions), int64_t{load.is_draining}}};
}

std::vector<PgStatement> end_dead_lives(const std::string& life) {
  const std::string is_dead = "lease_until < clock_timestamp() AND id <> CAST($1 AS uuid)";
  return {{kCutConnections + is_dead, {PgText{life}}},
          {"DELETE FROM nodes WHERE " + is_dead, {PgText{life}}}};
}

PgStatement read_servers() {
  return {
      "SELECT name, address, greatest(bytes_max - bytes_taken, 0) FROM nodes"
      " WHERE NOT draining AND lease_until > clock_timestamp() ORDER BY name",
      {}};
}

PgStatement end_life(const std::string& life) {
  return {"DELETE FROM nodes WHERE id = CAST($1 AS uuid)", {PgText{life}}};
}

}  // namespace burnish
