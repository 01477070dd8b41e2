#include "client/model/settings/known_servers.h"

#include <algorithm>

namespace burnish {

void remember_server(std::vector<KnownServer>& servers, const KnownServer& server) {
  std::erase_if(servers, [&](const KnownServer& each) { return each.address == server.address; });
  servers.insert(servers.begin(), server);
  if (servers.size() > kKnownServersMax) servers.resize(kKnownServersMax);
}

KnownServer server_at(const std::vector<KnownServer>& servers, const std::string& address) {
  for (const KnownServer& each : servers)
    if (each.address == address) return each;
  return {.address = address};
}

ConnectionTrust trust_in(const KnownServer& server, ConnectionTrust usual) {
  usual.tls = usual.tls || server.tls;
  if (!server.ca.empty()) usual.ca = server.ca;
  if (!server.token.empty()) usual.token = server.token;
  return usual;
}

}  // namespace burnish
