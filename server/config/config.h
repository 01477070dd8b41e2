#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "common/base/status.h"
#include "server/solver/solver.h"

namespace burnish {

/// Everything that can be told to burnish-server. Defaults, then the file, then the flags.
struct ServerConfig {
  std::string listen = "127.0.0.1:7411";        ///< HOST:PORT; port 0 takes a free one
  std::filesystem::path data = "burnish-data";  ///< the folder with everything that is kept
  int threads = 0;                              ///< of the solver; 0: all cores
  int workers = 16;                             ///< calls at work at once
  BackendKind backend = BackendKind::kAuto;
  std::string log_level = "info";  ///< trace, debug, info, warn, error, off
  bool insecure = false;           ///< plaintext beyond this machine

  int64_t sessions_max = 64;
  int64_t upload_bytes_max = int64_t{8} << 30;
  int64_t mesh_bytes_max = 0;  ///< in memory; 0: half of the machine's
};

/// Fails: invalid_argument naming the key, its value and its limits; failed_precondition when
/// `listen` is not on this machine and `insecure` is not set.
Status validate(const ServerConfig& config);

/// True for 127.0.0.0/8, ::1 and localhost.
bool is_loopback(const std::string& listen);

/// Fails: invalid_argument with the choices auto, cpu, cuda.
Result<BackendKind> parse_backend(const std::string& text);

/// mesh_bytes_max with its default filled in.
uint64_t resolved_mesh_bytes_max(const ServerConfig& config);

}  // namespace burnish
