#pragma once

#include <nlohmann/json.hpp>

#include "common/service/session_history.h"
#include "common/service/session_info.h"
#include "common/service/session_people.h"
#include "common/service/surface_measures.h"

namespace burnish {

nlohmann::ordered_json to_json(const ScanInfo& scan);
nlohmann::ordered_json to_json(const ScanDescription& description);
nlohmann::ordered_json to_json(const SessionInfo& session);
nlohmann::ordered_json to_json(const SessionState& state);
nlohmann::ordered_json to_json(const ExportSummary& summary);
nlohmann::ordered_json to_json(const SessionDeviation& measured);
nlohmann::ordered_json to_json(const HistoryEntry& entry);
nlohmann::ordered_json to_json(const SessionPeople& people);

}  // namespace burnish
