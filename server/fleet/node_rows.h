#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "server/postgres/pg_statement.h"

namespace burnish {

// The rows of the lives of servers, in the tables that the journal makes. Only the database's clock
// says whether a lease is over.

/// A server, as others know it.
struct NodeFacts {
  std::string name;     ///< no other server of the fleet has it
  std::string address;  ///< HOST:PORT for clients
};

/// Returns an id for a new life, as text.
std::string new_life();

/// Ends the earlier life of this name, and enters a new one. Sessions of the earlier life are free
/// then. The last statement changes no row if the earlier life has a lease and a connection.
std::vector<PgStatement> enter_life(const NodeFacts& node, const std::string& life,
                                    std::chrono::milliseconds lease);

/// How much a server has to do, as others know it.
struct NodeLoad {
  std::string backend;       ///< "cpu" or "cuda"
  uint64_t bytes_max = 0;    ///< of meshes and sessions
  uint64_t bytes_taken = 0;  ///< of them
  uint64_t sessions = 0;     ///< in memory
  bool is_draining = false;  ///< it ends: it takes no session, and anybody may take its sessions
};

/// Enters a life if no other server has the name and a lease. The last statement changes no row if
/// one has.
std::vector<PgStatement> enter_life_of_free_name(const NodeFacts& node, const std::string& life,
                                                 std::chrono::milliseconds lease,
                                                 const NodeLoad& load);

/// Changes no row if the life is over.
PgStatement renew_lease(const std::string& life, std::chrono::milliseconds lease,
                        const NodeLoad& load);

/// Ends other lives whose leases are over.
std::vector<PgStatement> end_dead_lives(const std::string& life);

PgStatement end_life(const std::string& life);

/// Reads name, address and free memory of all lives that have a lease and do not drain, by the
/// servers' names.
PgStatement read_servers();

}  // namespace burnish
