#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Text that comes from outside is bytes: it may be no UTF-8, and it may speak to a terminal.

/// Takes the first character off `text`, which must not be empty: its code point, or nothing and
/// one byte where no UTF-8 begins.
std::optional<char32_t> take_character(std::string_view& text);

/// Whether a character does something else than stand there: control characters (C0, DEL, C1), ends
/// of lines and paragraphs, and those that turn the direction of what follows.
bool is_control(char32_t character);

/// Whether all bytes are UTF-8 as RFC 3629 has it: nothing overlong, no surrogates, nothing above
/// U+10FFFF. True for "".
bool is_valid_utf8(std::string_view text);

/// Valid UTF-8 stays as it is. In other text each byte that is not part of a character becomes
/// four characters, "M\xfcller", and each backslash two, so that two names never become one.
std::string to_valid_utf8(std::string_view text);

/// Two lower-case digits for each byte.
std::string to_hex(std::span<const std::byte> bytes);

/// What scans, sessions, users and checkpoints may be called: 1 to kNameBytesMax bytes of UTF-8 in
/// which nothing is_control(). Fails: invalid_argument beginning with `what`.
Status check_name(std::string_view what, std::string_view name);

/// `text` as UTF-8: what is none becomes '?'. Beyond `bytes_max` bytes it is cut between two
/// characters, and "... (123 more bytes)" follows.
std::string shortened(std::string_view text, size_t bytes_max);

/// The same as one line that no terminal obeys: what is_control() becomes '?' as well.
std::string one_line(std::string_view text, size_t bytes_max);

}  // namespace burnish
