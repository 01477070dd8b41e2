#include "server/journal/session_maker.h"

#include <spdlog/spdlog.h>

#include "common/base/text.h"
#include "server/journal/row_checksum.h"

namespace burnish {

std::string checksum_of_maker(const SessionRecord& record) {
  return record.maker ? row_checksum_of(record.id, *record.maker) : std::string();
}

std::optional<std::string> maker_of_row(const std::string& session_id, const std::string& maker,
                                        const std::string& checksum) {
  if (maker.empty() && checksum.empty()) return std::nullopt;
  if (checksum == row_checksum_of(session_id, maker)) return to_valid_utf8(maker);
  spdlog::error("session {}: its maker in the journal is damaged; its first owner counts as it",
                to_valid_utf8(session_id));
  return std::nullopt;
}

}  // namespace burnish
