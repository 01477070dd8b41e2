#pragma once

#include <nlohmann/json.hpp>

#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"

namespace burnish {

nlohmann::ordered_json to_json(const ScanInfo& scan);
nlohmann::ordered_json to_json(const ScanDescription& description);
nlohmann::ordered_json to_json(const SessionInfo& session);
nlohmann::ordered_json to_json(const SessionState& state);
nlohmann::ordered_json to_json(const ExportSummary& summary);
nlohmann::ordered_json to_json(const HistoryEntry& entry);
nlohmann::ordered_json to_json(const SessionPeople& people);

/// To standard output, indented; bytes that are no UTF-8 are replaced.
void print_json(const nlohmann::ordered_json& json);

}  // namespace burnish
