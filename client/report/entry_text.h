#pragma once

#include <string>

#include "common/service/session_history.h"

namespace burnish {

/// Returns what an entry is, for a line of a list: "Smooth stroke".
const std::string& entry_name(const HistoryEntry& entry);

/// Returns the rest: "radius 4.69 mm, β 0, brush strength 0.5, 12 points". Empty: the name says
/// all. `unit`: the scan's.
std::string entry_details(const HistoryEntry& entry, const std::string& unit);

}  // namespace burnish
