#pragma once

#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Checks that an entry's name is a path below the folder that it is unpacked to: '/' between its
/// parts, no part empty, "." or "..", no drive, no '\' and no control character, at most
/// kArchiveNameBytesMax bytes. A folder's name ends in '/'.
/// Fails: invalid_argument that names the entry, the part and the limit.
Status check_entry_name(std::string_view name);

/// Returns the name for a message: in quotes, on one line.
std::string shown_entry(std::string_view name);

}  // namespace burnish
