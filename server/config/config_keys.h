#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "server/config/config.h"

namespace burnish {

/// One key of the configuration file: its name with dots, its member, and its limits.
struct ConfigKey {
  using Member =
      std::variant<int64_t ServerConfig::*, bool ServerConfig::*, std::string ServerConfig::*,
                   std::filesystem::path ServerConfig::*, BackendKind ServerConfig::*,
                   std::vector<std::string> ServerConfig::*>;

  std::string name;
  Member member;
  int64_t min = 0;  ///< of integers
  int64_t max = 0;
  std::vector<std::string> choices = {};  ///< of strings; empty: any
};

/// Returns all keys.
std::span<const ConfigKey> config_keys();

/// Returns null if there is no such key.
const ConfigKey* find_config_key(const std::string& name);

/// Fails: invalid_argument "limits.sessions_max = 0 is outside 1..1000000".
Status check_limits(const ConfigKey& key, const ServerConfig& config);

}  // namespace burnish
