#include "server/config/config_keys.h"

#include <algorithm>

namespace burnish {

static constexpr int64_t kManyBytes = int64_t{1} << 50;

std::span<const ConfigKey> config_keys() {
  using C = ServerConfig;
  static const std::vector<ConfigKey> keys = {
      {"listen", &C::listen},
      {"socket", &C::socket},
      {"socket_user_only", &C::socket_user_only},
      {"data", &C::data},
      {"journal", &C::journal},
      {"threads", &C::threads, 0, 1024},
      {"workers", &C::workers, 1, 1024},
      {"workers_per_user", &C::workers_per_user, 1, 1024},
      {"backend", &C::backend},
      {"devices", &C::devices, 0, 16},
      {"log_level", &C::log_level, 0, 0, {"trace", "debug", "info", "warn", "error", "off"}},
      {"log_format", &C::log_format, 0, 0, {"text", "json"}},
      {"drain_seconds", &C::drain_seconds, 0, 3600},
      {"idle_exit_seconds", &C::idle_exit_seconds, 0, 1'000'000'000},
      {"insecure", &C::insecure},
      {"users", &C::users},
      {"tls.certificate", &C::tls_certificate},
      {"tls.key", &C::tls_key},
      {"tls.client_ca", &C::tls_client_ca},
      {"tls.client_certificate_required", &C::tls_client_certificate_required},
      {"web.listen", &C::web_listen},
      {"web.hosts", &C::web_hosts},
      {"metrics.listen", &C::metrics_listen},
      {"library.shared", &C::library_shared},
      {"library.s3_endpoint", &C::s3_endpoint},
      {"library.s3_region", &C::s3_region},
      {"library.s3_addressing", &C::s3_addressing, 0, 0, {"auto", "path", "virtual"}},
      {"library.s3_credentials", &C::s3_credentials},
      {"library.s3_ca", &C::s3_ca},
      {"fleet.name", &C::fleet_name},
      {"fleet.advertise", &C::fleet_advertise},
      {"fleet.durability", &C::fleet_durability, 0, 0, {"single", "replicated"}},
      {"fleet.lease_ms", &C::fleet_lease_ms, 500, 600'000},
      {"fleet.heartbeat_ms", &C::fleet_heartbeat_ms, 100, 60'000},
      {"fleet.alone_ms", &C::fleet_alone_ms, 0, 600'000},
      {"sessions.idle_spill_seconds", &C::idle_spill_seconds, 0, 1'000'000'000},
      {"limits.sessions_max", &C::sessions_max, 1, 1'000'000},
      {"limits.kept_sessions_per_user", &C::kept_sessions_per_user, 1, 1'000'000},
      {"limits.sessions_for_owners", &C::sessions_for_owners, 0, 1'000'000},
      {"limits.history_bytes_per_session", &C::history_bytes_per_session, 1 << 16, kManyBytes},
      {"limits.history_bytes_per_user", &C::history_bytes_per_user, 1 << 16, kManyBytes},
      {"limits.sessions_per_user", &C::sessions_per_user, 1, 1'000'000},
      {"limits.streams_per_user", &C::streams_per_user, 1, 1'000'000},
      {"limits.requests_per_user", &C::requests_per_user, 1, 1'000'000},
      {"limits.request_bytes_per_user", &C::request_bytes_per_user, 16 << 20, int64_t{1} << 40},
      {"limits.connections_max", &C::connections_max, 1, 65'536},
      {"limits.connections_per_peer", &C::connections_per_peer, 1, 65'536},
      {"limits.silent_connection_seconds", &C::silent_connection_seconds, 1, 86'400},
      {"limits.silent_upload_seconds", &C::silent_upload_seconds, 1, 86'400},
      {"limits.upload_bytes_max", &C::upload_bytes_max, 1, kManyBytes},
      {"limits.upload_bytes_per_user", &C::upload_bytes_per_user, 1, kManyBytes},
      {"limits.memory_bytes_max", &C::memory_bytes_max, 0, kManyBytes},
      {"limits.device_memory_bytes_max", &C::device_memory_bytes_max, 0, kManyBytes},
  };
  return keys;
}

const ConfigKey* find_config_key(const std::string& name) {
  const auto keys = config_keys();
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [&](const ConfigKey& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

static Status check_choice(const ConfigKey& key, const std::string& value) {
  const auto& choices = key.choices;
  if (choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end())
    return Status::ok();
  std::string list;
  for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
  return invalid_argument(key.name + " = '" + value + "' is not one of " + list);
}

Status check_limits(const ConfigKey& key, const ServerConfig& config) {
  if (const auto* text = std::get_if<std::string ServerConfig::*>(&key.member))
    return check_choice(key, config.**text);
  const auto* integer = std::get_if<int64_t ServerConfig::*>(&key.member);
  if (integer == nullptr) return Status::ok();
  const int64_t value = config.**integer;
  if (value >= key.min && value <= key.max) return Status::ok();
  return invalid_argument(key.name + " = " + std::to_string(value) + " is outside " +
                          std::to_string(key.min) + ".." + std::to_string(key.max));
}

}  // namespace burnish
