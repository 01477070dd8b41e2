#include "server/config/config.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>

#include "common/base/parse_number.h"
#include "common/base/process_memory.h"
#include "server/config/config_keys.h"

namespace burnish {

static Status check_address(const std::string& key, const std::string& address) {
  const size_t colon = address.rfind(':');
  if (colon != std::string::npos && colon > 0 &&
      parse_number<uint16_t>(std::string_view(address).substr(colon + 1)))
    return Status::ok();
  return invalid_argument(key + " = '" + address + "' is not HOST:PORT with a port in 0..65535");
}

static Status check_socket(const std::filesystem::path& socket) {
  static constexpr size_t kBytesMax = 107;  // of sockaddr_un's path
  if (socket.native().size() <= kBytesMax) return Status::ok();
  return invalid_argument("socket = '" + socket.string() + "' has " +
                          std::to_string(socket.native().size()) +
                          " bytes, the limit of a socket's path is " + std::to_string(kBytesMax));
}

// The value may hold a password by mistake, so that no message repeats it.
static Status check_journal(const std::string& journal) {
  if (journal.empty() || journal.starts_with("postgresql://") || journal.starts_with("postgres://"))
    return Status::ok();
  return invalid_argument(
      "journal is not a URI that begins with postgresql://; leave it out for a file in the data "
      "folder");
}

/// The name is a folder's, and a header's of HTTP.
static Status check_fleet_name(const std::string& name) {
  static constexpr size_t kBytesMax = 63;
  const auto fits = [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.');
  };
  if (name.size() <= kBytesMax && std::ranges::all_of(name, fits) && name.front() != '.')
    return Status::ok();
  return invalid_argument("fleet.name = '" + name + "' is not 1 to " + std::to_string(kBytesMax) +
                          " letters, digits, '-', '_' and '.', without '.' in front");
}

static Status check_fleet(const ServerConfig& config) {
  if (!config.library_shared.empty() && config.fleet_name.empty())
    return invalid_argument(
        "library.shared = '" + config.library_shared.string() +
        "' needs fleet.name: the catalogue of its scans is in the fleet's database");
  if (!config.fleet_name.empty()) RETURN_IF_ERROR(check_fleet_name(config.fleet_name));
  if (!config.fleet_name.empty() && config.journal.empty())
    return invalid_argument("fleet.name = '" + config.fleet_name +
                            "' needs journal, the database that the fleet shares");
  if (!config.fleet_advertise.empty())
    RETURN_IF_ERROR(check_address("fleet.advertise", config.fleet_advertise));
  if (config.fleet_lease_ms >= 2 * config.fleet_heartbeat_ms) return Status::ok();
  return invalid_argument(
      "fleet.lease_ms = " + std::to_string(config.fleet_lease_ms) +
      " is less than twice fleet.heartbeat_ms = " + std::to_string(config.fleet_heartbeat_ms));
}

/// An endpoint may hold a password by mistake, so that only one that has none is repeated.
static Status check_s3(const ServerConfig& config) {
  const std::string shared = config.library_shared.string();
  const bool has_bucket = shared.starts_with("s3://");
  for (const auto& [key, is_set] : {std::pair("s3_endpoint", !config.s3_endpoint.empty()),
                                    std::pair("s3_credentials", !config.s3_credentials.empty()),
                                    std::pair("s3_ca", !config.s3_ca.empty())})
    if (is_set && !has_bucket)
      return invalid_argument(std::string("library.") + key + " is set, but library.shared = '" +
                              shared + "' is not a bucket, s3://BUCKET[/PREFIX]");
  static constexpr std::string_view kPlain = "http://";
  if (!config.s3_endpoint.starts_with(kPlain) || config.insecure) return Status::ok();
  const std::string host = config.s3_endpoint.substr(kPlain.size());
  const bool has_port = host.rfind(':') != std::string::npos && !host.ends_with(']');
  if (is_loopback(has_port ? host : host + ":80")) return Status::ok();
  const std::string value = host.find('@') == std::string::npos ? config.s3_endpoint : "http://...";
  return failed_precondition("library.s3_endpoint = '" + value +
                             "' would have the scans cross the network in plain text; use https, "
                             "or pass --insecure to allow it");
}

static Status check_tls(const ServerConfig& config) {
  if (config.tls_certificate.empty() != config.tls_key.empty())
    return invalid_argument("tls.certificate = '" + config.tls_certificate.string() +
                            "' and tls.key = '" + config.tls_key.string() +
                            "': give both or neither");
  if (config.tls_client_ca.empty()) return Status::ok();
  if (config.tls_certificate.empty())
    return invalid_argument("tls.client_ca = '" + config.tls_client_ca.string() +
                            "' needs tls.certificate and tls.key");
  if (config.users.empty())
    return invalid_argument("tls.client_ca = '" + config.tls_client_ca.string() +
                            "' needs users, which gives the owner of each certificate a role");
  return Status::ok();
}

static Status check_exposure(const std::string& key, const std::string& address,
                             const ServerConfig& config) {
  if (address.empty() || config.insecure || is_loopback(address)) return Status::ok();
  const std::string reachable = key + " = '" + address + "' is reachable from other machines, ";
  if (config.tls_certificate.empty())
    return failed_precondition(reachable +
                               "in plain text; set tls.certificate and tls.key, or pass "
                               "--insecure to allow it");
  if (config.users.empty())
    return failed_precondition(reachable +
                               "without authentication; set users, or pass "
                               "--insecure to allow it");
  return Status::ok();
}

static Status check_metrics_exposure(const ServerConfig& config) {
  if (config.metrics_listen.empty() || config.insecure || is_loopback(config.metrics_listen))
    return Status::ok();
  return failed_precondition(
      "metrics.listen = '" + config.metrics_listen +
      "' is reachable from other machines, in plain text and without "
      "authentication; use a loopback address, or pass --insecure to allow it");
}

bool is_loopback(const std::string& listen) {
  std::string host = listen.substr(0, listen.rfind(':'));
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  in_addr ipv4;
  in6_addr ipv6;
  if (inet_pton(AF_INET, host.c_str(), &ipv4) == 1)
    return ntohl(ipv4.s_addr) >> 24 == IN_LOOPBACKNET;
  if (inet_pton(AF_INET6, host.c_str(), &ipv6) == 1) return IN6_IS_ADDR_LOOPBACK(&ipv6);
  return host == "localhost";
}

Status validate(const ServerConfig& config) {
  for (const ConfigKey& key : config_keys()) RETURN_IF_ERROR(check_limits(key, config));
  if (config.data.empty()) return invalid_argument("data is empty; name a folder");
  if (config.listen.empty() && config.socket.empty())
    return invalid_argument("listen and socket are both empty; nobody could connect");
  if (!config.listen.empty()) RETURN_IF_ERROR(check_address("listen", config.listen));
  if (!config.web_listen.empty()) RETURN_IF_ERROR(check_address("web.listen", config.web_listen));
  if (!config.metrics_listen.empty())
    RETURN_IF_ERROR(check_address("metrics.listen", config.metrics_listen));
  RETURN_IF_ERROR(check_socket(config.socket));
  RETURN_IF_ERROR(check_journal(config.journal));
  RETURN_IF_ERROR(check_fleet(config));
  RETURN_IF_ERROR(check_s3(config));
  RETURN_IF_ERROR(check_tls(config));
  RETURN_IF_ERROR(check_metrics_exposure(config));
  RETURN_IF_ERROR(check_exposure("web.listen", config.web_listen, config));
  return check_exposure("listen", config.listen, config);
}

Result<BackendKind> parse_backend(const std::string& text) {
  if (text == "auto") return BackendKind::kAuto;
  if (text == "cpu") return BackendKind::kCpu;
  if (text == "cuda") return BackendKind::kCuda;
  return invalid_argument("backend = '" + text + "' is not one of auto, cpu, cuda");
}

uint64_t resolved_memory_bytes_max(const ServerConfig& config) {
  if (config.memory_bytes_max > 0) return static_cast<uint64_t>(config.memory_bytes_max);
  return machine_memory_bytes() / 2;
}

}  // namespace burnish
