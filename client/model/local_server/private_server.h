#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

// The private burnish-server of this user on this computer: one for all windows on the same folder.
// It listens on a Unix socket that only this user can reach. It outlives the window that started
// it, and ends by itself when nobody is connected.

struct PrivateServerOptions {
  std::filesystem::path data;  ///< the folder with the scans; closed to others (0700)
  std::chrono::seconds idle_exit{60};
};

/// Returns the socket of a data folder's server: window.sock in the folder. If that path is too
/// long for a socket, it lies in burnish/ below $XDG_RUNTIME_DIR or in /tmp/burnish-UID.
std::filesystem::path private_socket(const std::filesystem::path& data);

/// Returns the memory that the server takes for its sessions, by its own choice.
uint64_t private_server_memory_bytes();

/// Finds the server, or starts the burnish-server beside this program. Returns its address once it
/// answers. Thread-safe.
/// Fails: not_found (no such program, or no folder); permission_denied (others can enter the
/// folder, or another user has the socket); unavailable (it ended; the message has the last line of
/// its log); cancelled.
Result<std::string> find_private_server(const PrivateServerOptions& options,
                                        const Progress& progress);

}  // namespace burnish
