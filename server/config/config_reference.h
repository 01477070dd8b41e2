#pragma once

#include <string>

namespace burnish {

/// Returns a configuration file with every key at its default, and comments that explain them:
/// deploy/server.example.toml.
std::string config_example();

/// Returns all keys as a JSON list, for documents: name, type, default, and min and max or choices.
std::string config_keys_json();

}  // namespace burnish
