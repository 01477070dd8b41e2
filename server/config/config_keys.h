#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "server/config/config.h"

namespace burnish {

/// One key of the configuration file: its name with dots, where its value goes, and its limits.
struct ConfigKey {
  using Member =
      std::variant<int64_t ServerConfig::*, bool ServerConfig::*, std::string ServerConfig::*,
                   std::filesystem::path ServerConfig::*, BackendKind ServerConfig::*>;

  std::string name;
  Member member;
  int64_t min = 0;  ///< of integers
  int64_t max = 0;
  std::vector<std::string> choices = {};  ///< of strings; empty: any
};

/// All keys that there are.
std::span<const ConfigKey> config_keys();

/// Null when there is no such key.
const ConfigKey* find_config_key(const std::string& name);

/// Fails: invalid_argument "limits.sessions_max = 0 is outside 1..1000000".
Status check_limits(const ConfigKey& key, const ServerConfig& config);

}  // namespace burnish
