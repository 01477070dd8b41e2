#pragma once

#include <span>

#include <nlohmann/json.hpp>

#include "tests/bench/peers/row.h"

namespace burnish::bench {

/// Prints the rows of one scan at one α and number of threads: a table, the winner of each column,
/// and whether the targets against both CHOLMODs are met. The product's row comes first.
void print_rows(std::span<const Row> rows);

nlohmann::ordered_json rows_to_json(std::span<const Row> rows);

}  // namespace burnish::bench
