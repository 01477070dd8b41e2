#pragma once

#include <filesystem>
#include <string_view>

#include "server/config/config.h"

namespace burnish {

/// Reads a TOML file over `config`; deploy/server.example.toml documents every key. Its paths are
/// relative to its folder. Fails: not_found; invalid_argument that names file, line, key, value and
/// limits.
Status read_config_file(const std::filesystem::path& path, ServerConfig& config);

/// Does the same from text; `name` is the file's path.
Status read_config_text(std::string_view text, const std::string& name, ServerConfig& config);

}  // namespace burnish
