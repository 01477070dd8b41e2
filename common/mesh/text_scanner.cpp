#include "common/mesh/text_scanner.h"

#include <algorithm>
#include <utility>

namespace burnish {

static bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

static std::string_view as_text(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TextScanner::TextScanner(std::span<const uint8_t> bytes, std::string name, TextSyntax syntax,
                         size_t lines_before)
    : rest_(as_text(bytes)), name_(std::move(name)), syntax_(syntax), line_number_(lines_before) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TextScanner::next_physical_line() {
  if (rest_.empty()) return false;
  const size_t end = std::min(rest_.find('\n'), rest_.size());
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++line_number_;
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  continues_ = syntax_.backslash_continues && line_.ends_with('\\');
  if (continues_) line_.remove_suffix(1);
  return true;
}

void TextScanner::skip_blanks() {
  size_t blanks = 0;
  while (blanks < line_.size() && is_blank(line_[blanks])) ++blanks;
  line_.remove_prefix(blanks);
  if (!syntax_.hash_comments || !line_.starts_with('#')) return;
  line_ = {};
  continues_ = false;  // comments often quote paths that end with a backslash
}

bool TextScanner::next_line() {
  while (continues_ && next_physical_line()) skip_blanks();
  while (next_physical_line()) {
    skip_blanks();
    if (!line_.empty()) return true;
  }
  line_ = {};
  return false;
}

std::string_view TextScanner::next_token() {
  skip_blanks();
  while (line_.empty() && continues_ && next_physical_line()) skip_blanks();
  size_t length = 0;
  while (length < line_.size() && !is_blank(line_[length])) ++length;
  const std::string_view token = line_.substr(0, length);
  line_.remove_prefix(length);
  return token;
}

Status TextScanner::error(const std::string& what) const {
  return invalid_argument(name_ + ": line " + std::to_string(line_number_) + ": " + what);
}

Status check_line_lengths(std::span<const uint8_t> bytes, const std::string& name) {
  std::string_view rest = as_text(bytes);
  for (size_t line = 1; rest.size() > kLineBytesMax; ++line) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    if (length > kLineBytesMax)
      return invalid_argument(name + ": line " + std::to_string(line) + " has " +
                              std::to_string(length) + " bytes, the limit is " +
                              std::to_string(kLineBytesMax));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return Status::ok();
}

}  // namespace burnish
