#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burnish {

/// Text that comes from outside is bytes: it may be no UTF-8, and it may speak to a terminal.

/// Takes the first character off `text`, which must not be empty: its code point, or nothing and
/// one byte where no UTF-8 begins.
std::optional<char32_t> take_character(std::string_view& text);

/// Whether a character does something else than stand there: control characters (C0, DEL, C1), ends
/// of lines and paragraphs, and those that turn the direction of what follows.
bool is_control(char32_t character);

/// `text` as UTF-8: what is none becomes '?'. Beyond `bytes_max` bytes it is cut between two
/// characters, and "... (123 bytes more)" follows.
std::string shortened(std::string_view text, size_t bytes_max);

/// The same as one line that no terminal obeys: what is_control() becomes '?' as well.
std::string one_line(std::string_view text, size_t bytes_max);

}  // namespace burnish
