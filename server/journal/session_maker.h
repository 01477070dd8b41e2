#pragma once

#include <optional>
#include <string>

#include "server/journal/journal.h"

namespace burnish {

// The maker in a session's row has a checksum of its own. Programs from before the maker read and
// write the row's other values with theirs, in a fleet also while this program runs.

/// Returns the checksum of the maker; "" if the record does not say who it is.
std::string checksum_of_maker(const SessionRecord& record);

/// Returns the maker that a row has. Returns null if the row does not say, and logs an error if the
/// checksum is not that of these values.
std::optional<std::string> maker_of_row(const std::string& session_id, const std::string& maker,
                                        const std::string& checksum);

}  // namespace burnish
