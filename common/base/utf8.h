#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// Whether all bytes are UTF-8 as RFC 3629 has it: nothing overlong, no surrogates, nothing above
/// U+10FFFF. True for "".
bool is_valid_utf8(std::string_view text);

/// Valid UTF-8 stays as it is. In other text each byte that is not part of a character becomes
/// four characters, "M\xfcller", and each backslash two, so that two names never become one.
std::string to_valid_utf8(std::string_view text);

}  // namespace burnish
