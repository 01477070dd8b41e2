// The form in which a user names a server.

#include <charconv>

#include "client/model/files/typed_path.h"
#include "client/model/settings/known_servers.h"

namespace burnish {

static constexpr int kPortMax = 65535;

ConnectionForm form_of(const KnownServer& server) {
  const size_t colon = server.address.rfind(':');
  ConnectionForm form;
  form.host = server.address.substr(0, colon);
  if (colon != std::string::npos) form.port = server.address.substr(colon + 1);
  form.ca = server.ca.string();
  form.token = server.token;
  form.user = server.user;
  form.tls = server.tls;
  form.keeps_token = server.keeps_token;
  return form;
}

static std::string problem_of_host(const std::string& host) {
  if (host.empty()) return "name a host, such as burnish.lab";
  if (host.find_first_of(" \t/") != std::string::npos)
    return "'" + host + "' has a space or a slash";
  const bool is_bracketed = host.starts_with('[') && host.ends_with(']');
  if (host.find(':') != std::string::npos && !is_bracketed)
    return "'" + host + "' has a colon; the port has its own field, an IPv6 address its brackets";
  return {};
}

static std::string problem_of_port(const std::string& port) {
  int number = 0;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
  const bool is_number = error == std::errc() && end == port.data() + port.size();
  if (is_number && number >= 1 && number <= kPortMax) return {};
  return "'" + port + "' is outside 1 to " + std::to_string(kPortMax);
}

static std::string problem_of_ca(const std::string& ca) {
  std::error_code ignored;
  if (ca.empty() || std::filesystem::is_regular_file(typed_path(ca), ignored)) return {};
  return "'" + ca + "' is not a file";
}

FormProblems problems_of(const ConnectionForm& form) {
  FormProblems problems{problem_of_host(form.host), problem_of_port(form.port),
                        problem_of_ca(form.ca), ""};
  if (form.token.find_first_of(" \t\r\n") != std::string::npos)
    problems.token = "a token has no spaces";
  return problems;
}

KnownServer server_of(const ConnectionForm& form) {
  return {.address = form.host + ":" + form.port,
          .tls = form.tls || !form.ca.empty(),
          .ca = typed_path(form.ca),
          .user = form.user,
          .token = form.token,
          .keeps_token = form.keeps_token && !form.token.empty()};
}

}  // namespace burnish
