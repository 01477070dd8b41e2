#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/connection/connection.h"

namespace burnish {

inline constexpr size_t kKnownServersMax = 8;

/// A server that the user connected to, and how.
struct KnownServer {
  std::string address;  ///< HOST:PORT
  bool tls = false;
  std::filesystem::path ca;  ///< PEM file; empty: the system's
  std::string user;          ///< empty: as in the preferences
  std::string token;
  bool keeps_token = false;  ///< the token goes to disk with the preferences
  bool operator==(const KnownServer&) const = default;
};

/// Puts a server first, in place of the entry with its address, and drops the oldest.
void remember_server(std::vector<KnownServer>& servers, const KnownServer& server);

/// Returns the entry with this address; without one a server that is known by its address alone.
KnownServer server_at(const std::vector<KnownServer>& servers, const std::string& address);

/// Returns how to trust a server: as `usual`, but with what is known of it.
ConnectionTrust trust_in(const KnownServer& server, ConnectionTrust usual);

/// The text in the fields of a connection dialog.
struct ConnectionForm {
  std::string host, port = "7411", ca, token, user;
  bool tls = false;
  bool keeps_token = false;
};

/// The text for a server.
ConnectionForm form_of(const KnownServer& server);

/// A word about each field that is wrong; empty: it is right.
struct FormProblems {
  std::string host, port, ca, token;
  bool has_none() const { return host.empty() && port.empty() && ca.empty() && token.empty(); }
};

/// Checks the fields before anything connects. Each message names value and limit.
FormProblems problems_of(const ConnectionForm& form);

/// Returns the server of a form. Needs: a form without problems.
KnownServer server_of(const ConnectionForm& form);

}  // namespace burnish
