#include "server/config/config.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unistd.h>

namespace burnish {

static Status check_between(const std::string& key, int64_t value, int64_t min, int64_t max) {
  if (value >= min && value <= max) return Status::ok();
  return invalid_argument(key + " = " + std::to_string(value) + " is outside " +
                          std::to_string(min) + ".." + std::to_string(max));
}

static Status check_listen(const std::string& listen) {
  const size_t colon = listen.rfind(':');
  int port = -1;
  if (colon != std::string::npos && colon > 0) {
    const char* end = listen.data() + listen.size();
    const auto parsed = std::from_chars(listen.data() + colon + 1, end, port);
    if (parsed.ec != std::errc() || parsed.ptr != end) port = -1;
  }
  if (port >= 0 && port <= 65535) return Status::ok();
  return invalid_argument("listen = '" + listen + "' is not HOST:PORT with a port in 0..65535");
}

static Status check_log_level(const std::string& level) {
  static constexpr std::array kLevels = {"trace", "debug", "info", "warn", "error", "off"};
  if (std::find(kLevels.begin(), kLevels.end(), level) != kLevels.end()) return Status::ok();
  return invalid_argument("log_level = '" + level +
                          "' is none of trace, debug, info, warn, error, off");
}

bool is_loopback(const std::string& listen) {
  std::string host = listen.substr(0, listen.rfind(':'));
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return host == "localhost" || host == "::1" || host.starts_with("127.");
}

Status validate(const ServerConfig& config) {
  static constexpr int64_t kMany = int64_t{1} << 50;
  RETURN_IF_ERROR(check_listen(config.listen));
  RETURN_IF_ERROR(check_log_level(config.log_level));
  if (config.data.empty()) return invalid_argument("data is empty; name a folder");
  RETURN_IF_ERROR(check_between("threads", config.threads, 0, 1024));
  RETURN_IF_ERROR(check_between("workers", config.workers, 1, 1024));
  RETURN_IF_ERROR(check_between("limits.sessions_max", config.sessions_max, 1, 1'000'000));
  RETURN_IF_ERROR(check_between("limits.upload_bytes_max", config.upload_bytes_max, 1, kMany));
  RETURN_IF_ERROR(check_between("limits.mesh_bytes_max", config.mesh_bytes_max, 0, kMany));
  if (!is_loopback(config.listen) && !config.insecure)
    return failed_precondition("listen = '" + config.listen +
                               "' is reachable from other machines, in plain text and without a "
                               "password; say --insecure if that is meant");
  return Status::ok();
}

Result<BackendKind> parse_backend(const std::string& text) {
  if (text == "auto") return BackendKind::kAuto;
  if (text == "cpu") return BackendKind::kCpu;
  if (text == "cuda") return BackendKind::kCuda;
  return invalid_argument("backend = '" + text + "' is none of auto, cpu, cuda");
}

uint64_t resolved_mesh_bytes_max(const ServerConfig& config) {
  if (config.mesh_bytes_max > 0) return static_cast<uint64_t>(config.mesh_bytes_max);
  return static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<uint64_t>(sysconf(_SC_PAGESIZE)) / 2;
}

}  // namespace burnish
