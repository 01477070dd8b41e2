#pragma once

#include <filesystem>
#include <string_view>

#include "server/config/config.h"

namespace burnish {

/// Reads a TOML file over `config`:
///
///     listen = "127.0.0.1:7411"     data = "burnish-data"      backend = "auto"
///     threads = 0                   workers = 16               log_level = "info"
///     insecure = false
///     [limits]
///     sessions_max = 64             upload_bytes_max = 8589934592    mesh_bytes_max = 0
///
/// Fails: not_found; invalid_argument naming file, line and key for anything else in it.
Status read_config_file(const std::filesystem::path& path, ServerConfig& config);

/// The same from text; `name` serves the messages.
Status read_config_text(std::string_view text, const std::string& name, ServerConfig& config);

}  // namespace burnish
