#include "server/postgres/pg_status.h"

#include <string_view>

namespace burnish {

static StatusCode code_of_sqlstate(const std::string& sqlstate) {
  const std::string kind = sqlstate.substr(0, 2);
  if (sqlstate == "23505") return StatusCode::kAlreadyExists;  // unique_violation
  if (sqlstate == "23503") return StatusCode::kNotFound;       // foreign_key_violation
  if (sqlstate == "55P03") return StatusCode::kUnavailable;    // lock_not_available
  if (sqlstate == "53300") return StatusCode::kUnavailable;    // too_many_connections
  if (sqlstate == "25006") return StatusCode::kUnavailable;    // a standby: read only
  if (sqlstate == "42501") return StatusCode::kPermissionDenied;
  if (sqlstate == "XX001" || sqlstate == "XX002") return StatusCode::kDataLoss;
  if (kind == "08" || kind == "57" || kind == "40") return StatusCode::kUnavailable;
  if (kind == "28") return StatusCode::kPermissionDenied;
  if (kind == "53" || kind == "54") return StatusCode::kResourceExhausted;
  return StatusCode::kInternal;
}

std::string trimmed_words(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

Status pg_status(const std::string& sqlstate, const std::string& message) {
  return {code_of_sqlstate(sqlstate), "journal: " + trimmed_words(message)};
}

// Constraints and conflicts are found before the commit is written.
bool is_sure_refusal(const std::string& sqlstate) {
  return sqlstate.starts_with("23") || (sqlstate.starts_with("40") && sqlstate != "40003");
}

}  // namespace burnish
