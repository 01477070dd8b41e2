#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

// The burnish-server of this user on this computer: one for all windows on the same folder. It
// listens on a Unix socket that nobody else can reach, outlives the window that started it, and
// ends by itself when nobody is connected any more.

struct PrivateServerOptions {
  std::filesystem::path data;  ///< the folder with the scans; closed to others (0700)
  std::chrono::seconds idle_exit{60};
};

/// Where the server of a data folder listens: window.sock in it, or, where that path is too long
/// for a socket, in burnish/ below $XDG_RUNTIME_DIR or in /tmp/burnish-UID.
std::filesystem::path private_socket(const std::filesystem::path& data);

/// Finds the server, or starts the burnish-server beside this program, and returns its address once
/// it answers. From any thread; many may ask at once.
/// Fails: not_found (no such program, or no folder); permission_denied (a folder that others can
/// enter, or somebody else at the socket); unavailable (it ended, with what it said last);
/// cancelled.
Result<std::string> find_private_server(const PrivateServerOptions& options,
                                        const Progress& progress);

}  // namespace burnish
