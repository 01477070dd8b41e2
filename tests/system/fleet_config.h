#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/common/temporary_folder.h"

namespace burnish {

/// A server of a fleet under test.
struct FleetServer {
  std::string name;
  std::string journal;             ///< URI of the database
  std::filesystem::path shared{};  ///< folder or bucket of the fleet's scans; empty: none
  std::string library{};           ///< more lines of [library]
  int lease_ms = 1500;             ///< short: the database has the clock, and tests wait for it
  int heartbeat_ms = 300;
  int alone_ms = 0;
  std::string advertise{};       ///< where clients reach it; empty: nobody is told
  int64_t memory_bytes_max = 0;  ///< 0: as the server chooses
};

/// Writes the server's configuration into the folder. Returns the flags that name it.
inline std::vector<std::string> fleet_flags(const TemporaryFolder& folder,
                                            const FleetServer& server) {
  std::string text = "journal = \"" + server.journal + "\"\n";
  if (!server.shared.empty())
    text += "[library]\nshared = \"" + server.shared.string() + "\"\n" + server.library;
  text += "[fleet]\nname = \"" + server.name + "\"\nlease_ms = " + std::to_string(server.lease_ms) +
          "\nheartbeat_ms = " + std::to_string(server.heartbeat_ms) +
          "\nalone_ms = " + std::to_string(server.alone_ms) + "\nadvertise = \"" +
          server.advertise + "\"\n[limits]\nconnections_per_peer = 256\n";
  text += "memory_bytes_max = " + std::to_string(server.memory_bytes_max) + "\n";
  return {"--config", folder.write(server.name + ".toml", text).string()};
}

}  // namespace burnish
