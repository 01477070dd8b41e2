#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// Which requests of browsers the gateway takes. A page of another origin must not reach a server
/// in the user's own network with the user's rights.
struct RequestRules {
  std::vector<std::string> hosts;  ///< web.hosts, the host of web.listen, names of this machine
  bool is_tls = false;
};

/// Returns the host name of this machine, "scanner.lab", and its first part alone and with
/// ".local".
std::vector<std::string> names_of_this_machine();

/// Checks the header Host, "burnish.lab:7443". Allowed are names of loopback, `local_address` (the
/// numeric address that the client has connected to), and the rules' hosts. So a foreign name that
/// was rebound to this machine is refused. Fails: permission_denied.
Status check_host(const RequestRules& rules, std::string_view host, std::string_view local_address);

/// Checks the header Origin against Host. A client without one is not a browser. In plain text both
/// schemes are allowed, for a proxy may have the TLS. Fails: permission_denied.
Status check_origin(const RequestRules& rules, std::string_view origin, std::string_view host);

/// Returns whether a target takes a WebSocket for calls: "/rpc", or "/rpc?node=NAME", by which a
/// proxy finds the server of a fleet that has the session.
bool is_for_calls(std::string_view target);

}  // namespace burnish
