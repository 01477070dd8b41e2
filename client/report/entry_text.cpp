#include "client/report/entry_text.h"

#include "client/report/length_text.h"

namespace burnish {

// An older server has the summary alone.
const std::string& entry_name(const HistoryEntry& entry) {
  return entry.name.empty() ? entry.summary : entry.name;
}

std::string entry_details(const HistoryEntry& entry, const std::string& unit) {
  if (!(entry.radius > 0)) return entry.details;
  return "radius " + length_text(entry.radius, unit) + ", " + entry.details;
}

}  // namespace burnish
