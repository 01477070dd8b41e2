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

/// Returns the path that an entry's name means: "./a" is "a". A '\' is a '/' if the archive says
/// that a program of Windows made the entry; .NET writes such names. The folder of all entries is
/// kArchiveRoot.
std::string plain_entry_name(std::string_view name, bool is_of_windows);

inline constexpr std::string_view kArchiveRoot = "./";

/// Returns the name for a message: in quotes, on one line.
std::string shown_entry(std::string_view name);

}  // namespace burnish
