#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "client/connection/connection.h"

namespace burnish {

/// Options of every command that talks to a server.
struct ServerOption {
  std::string server = "127.0.0.1:7411";
  double timeout_seconds = 10;
  bool json = false;
  ConnectionTrust trust;
  std::string token_file;
  std::string user;

  Result<Connection> connect() const;
  /// Returns the trust with the token from the file. Fails: as errno says; invalid_argument for an
  /// empty file.
  Result<ConnectionTrust> full_trust() const;
};

/// Adds --server, --timeout, --json, --user, and the options that a remote server needs.
void add_server_options(CLI::App& command, ServerOption& option);

/// Adds --depth and --curvature-radius.
void add_prepared_options(CLI::App& command, PreparedKey& key);

}  // namespace burnish
