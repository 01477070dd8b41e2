#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// Longer lines are refused, not searched: a sensible text mesh has none.
inline constexpr size_t kLineBytesMax = 1 << 20;

struct TextSyntax {
  bool hash_comments = false;        ///< a token that begins with # ends the line
  bool backslash_continues = false;  ///< a line that ends with \ continues in the next line
};

/// Cuts text into lines and blank-separated tokens, and knows the place for messages. Lines end in
/// LF, CRLF or CR; the last needs no end. Skips blank lines and a leading byte order mark.
class TextScanner {
 public:
  /// `steps` hears of each line and token.
  TextScanner(std::span<const uint8_t> bytes, std::string name, TextSyntax syntax = {},
              size_t lines_before = 0, const FileSteps& steps = {});

  /// Goes to the next line that has a token. Returns false at the end of the text.
  bool next_line();

  /// Returns the current line's next token; empty at the end of the line.
  std::string_view next_token();

  /// Returns whether the current line has no further token.
  bool at_line_end();

  /// Return the unread part of the current line, and how many bytes follow the line.
  std::string_view line_rest() const { return line_; }
  size_t bytes_after_line() const { return rest_.size(); }
  size_t line_number() const { return line_number_; }

  /// invalid_argument: "name: line 12: what".
  Status error(const std::string& what) const;

 private:
  bool next_physical_line();
  size_t line_length();
  void skip_blanks();

  std::string_view line_;  // from the next unread byte to the line's end
  std::string_view rest_;  // after the line
  std::string name_;
  TextSyntax syntax_;
  size_t line_number_;
  FileSteps steps_;
  bool continues_ = false;
  size_t from_next_lf_ = SIZE_MAX;  // bytes from the next LF to the end of the text
};

/// Fails: invalid_argument that names the first line longer than kLineBytesMax.
Status check_line_lengths(std::span<const uint8_t> bytes, const std::string& name,
                          FileSteps steps = {});

}  // namespace burnish
