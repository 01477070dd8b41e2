#pragma once

#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// The rules for new names of scans and sessions. Names from before there were rules stay, and are
/// found as they are.

/// Fails: invalid_argument that begins with `what`: as check_name(); a name that begins or ends
/// with a blank, or has a character that nobody sees.
Status check_kept_name(std::string_view what, std::string_view name);

/// Does the same, and refuses a name that could be the beginning of an id: 4 to 64 hexadecimal
/// digits.
Status check_scan_name(std::string_view name);

/// Returns a name as a reader sees it, by Unicode's NFKC_Casefold: without case, joiners, the width
/// of letters and other ways to write a character. Two scans must not have names that look alike.
/// Does not know which letters of different scripts have one shape.
std::string look_of_name(std::string_view name);

/// Returns a name that check_scan_name() takes, as near to this one as it can be: without blanks at
/// its ends and unseen characters, and with a number behind it. Number 1 adds none unless the name
/// needs it: "scan", "scan (2)"; "face" (hexadecimal) is "face (1)".
std::string numbered_scan_name(std::string_view name, int number);

}  // namespace burnish
