#pragma once

#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "client/cli/bench/load_client.h"

namespace burnish {

/// Results of the checks after a load run.
struct LoadChecks {
  uint64_t acknowledged = 0;            ///< edits
  uint64_t missing_from_history = 0;    ///< acknowledged, but missing
  uint64_t unanswered = 0;              ///< sent, neither acknowledged nor refused
  bool clients_agree = false;           ///< all clients of a session show the same settled surface
  bool replay_agrees = false;           ///< a fork, made by replay, has the same fields
  std::vector<std::string> objections;  ///< in words; empty: no objection

  bool is_good() const { return objections.empty(); }
};

/// Makes a report whose keys name their units. Latencies have p50, p95, p99 and max.
nlohmann::ordered_json load_report(std::span<const LoadFigures> clients, const LoadChecks& checks);

void print_load_report(const nlohmann::ordered_json& report);

}  // namespace burnish
