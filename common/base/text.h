#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Text from outside is only bytes: it may not be UTF-8, and it may control a terminal.

/// Removes the first character from `text` and returns its code point. If `text` does not begin
/// with UTF-8, removes one byte and returns nothing. Needs: `text` is not empty.
std::optional<char32_t> take_character(std::string_view& text);

/// Returns true for characters that do more than show: control characters (C0, DEL, C1), ends of
/// lines and paragraphs, and characters that change the direction of the text after them.
bool is_control(char32_t character);

/// Returns whether all bytes are UTF-8 by RFC 3629: nothing overlong, no surrogates, nothing above
/// U+10FFFF. Returns true for "".
bool is_valid_utf8(std::string_view text);

/// Returns valid UTF-8 unchanged. In other text each byte that is not part of a character becomes
/// four characters, "M\xfcller", and each backslash becomes two, so that two names never become
/// equal.
std::string to_valid_utf8(std::string_view text);

/// Returns the fewest digits that are read back as the same number.
std::string shortest_text(double number);

/// Returns two lower-case hexadecimal digits for each byte.
std::string to_hex(std::span<const std::byte> bytes);

/// Checks the name of a scan, session, user or checkpoint: 1 to kNameBytesMax bytes of UTF-8 in
/// which no character is_control(). Fails: invalid_argument that begins with `what`.
Status check_name(std::string_view what, std::string_view name);

/// Returns the name that is most like a file's: without what check_name() refuses, cut between two
/// characters. A byte that is not UTF-8 becomes '?', a name of nothing "scan".
std::string name_like(std::string_view text);

/// Returns `text` as UTF-8; each byte that is not UTF-8 becomes '?'. Text beyond `bytes_max` bytes
/// is cut between two characters, and "... (123 more bytes)" follows.
std::string shortened(std::string_view text, size_t bytes_max);

/// Returns the same as one line that is safe on a terminal: a character that is_control() becomes
/// '?' too.
std::string one_line(std::string_view text, size_t bytes_max);

/// Joins the first few names of a file for a message, each as one_line(), and says how many more
/// there are: "a.png, b.png", "a, b, c, d, e and 7 more".
std::string few_names(std::span<const std::string> names);

/// Returns "scan.obj names files that are not there: skin.png". Needs: a name.
std::string missing_text(const std::string& file, std::span<const std::string> missing);

/// Returns "10 s", "0.25 s".
std::string seconds_text(std::chrono::milliseconds time);

}  // namespace burnish
