#pragma once

#include <nlohmann/json.hpp>

namespace burnish {

/// Prints to standard output, indented. Replaces bytes that are not UTF-8.
void print_json(const nlohmann::ordered_json& json);

}  // namespace burnish
