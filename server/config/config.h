#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/solver/solver.h"

namespace burnish {

/// All settings of burnish-server. Defaults come first, then the file, then the flags.
/// deploy/server.example.toml explains each key; config_keys.h has names and limits.
struct ServerConfig {
  std::string listen = "127.0.0.1:7411";  ///< HOST:PORT, port 0 for a free port; empty: no TCP
  std::filesystem::path socket;           ///< a Unix socket in addition
  bool socket_user_only = false;          ///< its mode: 0600, else 0660
  std::filesystem::path data = "burnish-data";  ///< the folder of all stored data
  std::string journal;           ///< URI of a PostgreSQL database; empty: a file in `data`
  int64_t threads = 0;           ///< of the solver; 0: all cores
  int64_t workers = 16;          ///< long calls at once, and as many that wait
  int64_t workers_per_user = 4;  ///< at once for one user
  BackendKind backend = BackendKind::kAuto;
  int64_t devices = 0;  ///< GPUs that share one scan; 0: one, or as many as have room for it
  std::string log_level = "info";
  std::string log_format = "text";
  int64_t drain_seconds = 10;     ///< for running calls after a signal to end
  int64_t idle_exit_seconds = 0;  ///< without a connection until the server ends; 0: never
  bool insecure = false;          ///< plaintext, no users, or metrics for other machines
  std::filesystem::path users;    ///< roles of users; empty: no authentication

  std::filesystem::path tls_certificate;
  std::filesystem::path tls_key;
  std::filesystem::path tls_client_ca;
  bool tls_client_certificate_required = true;

  std::string web_listen;              ///< HOST:PORT for browsers; empty: none
  std::vector<std::string> web_hosts;  ///< names of this server that browsers may use

  std::string metrics_listen;  ///< HOST:PORT; empty: no metrics

  std::filesystem::path library_shared;  ///< folder or bucket of the fleet's originals; empty: none
  std::string s3_endpoint;               ///< http[s]://HOST[:PORT]; empty: that of AWS
  std::string s3_region = "us-east-1";
  std::string s3_addressing = "auto";    ///< where URLs have the bucket's name
  std::filesystem::path s3_credentials;  ///< a file; empty: the environment
  std::filesystem::path s3_ca;           ///< authorities of the endpoint; empty: the system's

  std::string fleet_name;       ///< of this server among those that share the journal; empty: alone
  std::string fleet_advertise;  ///< HOST:PORT at which clients reach this server; empty: a proxy's
  std::string fleet_durability = "single";  ///< machines that have an acknowledged edit
  int64_t fleet_lease_ms = 10'000;          ///< until a server that is not heard counts as dead
  int64_t fleet_heartbeat_ms = 3'000;       ///< between two signs of this server
  int64_t fleet_alone_ms = 60'000;          ///< that it shows sessions without the database

  int64_t idle_spill_seconds = 600;  ///< until an unused session is unloaded; 0: never

  int64_t sessions_max = 64;
  int64_t kept_sessions_per_user = 32;                   ///< that a user made, in memory or not
  int64_t sessions_for_owners = 4;                       ///< the last places of sessions_max
  int64_t history_bytes_per_session = int64_t{1} << 30;  ///< of edits
  int64_t history_bytes_per_user = int64_t{4} << 30;     ///< of the sessions that a user made
  int64_t sessions_per_user = 16;                        ///< in memory
  int64_t streams_per_user = 64;                         ///< running streaming calls
  int64_t requests_per_user = 1024;                      ///< waiting for a worker
  int64_t request_bytes_per_user = int64_t{64} << 20;    ///< of waiting and running requests
  int64_t connections_max = 256;
  int64_t connections_per_peer = 64;       ///< of one address
  int64_t silent_connection_seconds = 30;  ///< until a call is admitted: not health
  int64_t silent_upload_seconds = 30;      ///< between two parts of a file
  int64_t upload_bytes_max = int64_t{8} << 30;
  int64_t upload_bytes_per_user = int64_t{16} << 30;  ///< uploads that are not finished
  int64_t memory_bytes_max = 0;         ///< meshes, sessions, clients; 0: half of the machine's
  int64_t device_memory_bytes_max = 0;  ///< the same on a GPU; 0: all of its memory
};

/// Fails: invalid_argument that names the key, its value and its limits, or keys that do not fit
/// together; failed_precondition if `insecure` is not set and other machines could connect in plain
/// text, connect without authentication, or read the metrics.
Status validate(const ServerConfig& config);

/// Returns true for the addresses 127.0.0.0/8 and ::1, and for localhost. `listen` is HOST:PORT.
bool is_loopback(const std::string& listen);

/// Fails: invalid_argument with the choices auto, cpu, cuda.
Result<BackendKind> parse_backend(const std::string& text);

/// Returns memory_bytes_max, or its default: half of machine_memory_bytes().
uint64_t resolved_memory_bytes_max(const ServerConfig& config);

}  // namespace burnish
