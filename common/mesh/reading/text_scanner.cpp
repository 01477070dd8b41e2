#include "common/mesh/reading/text_scanner.h"

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
                         size_t lines_before, const FileSteps& steps)
    : rest_(as_text(bytes)),
      name_(std::move(name)),
      syntax_(syntax),
      line_number_(lines_before),
      steps_(steps) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

// Remembers the next LF: a text whose lines end in CR may have none, and is searched once.
size_t TextScanner::line_length() {
  if (from_next_lf_ > rest_.size())
    from_next_lf_ = rest_.size() - std::min(rest_.find('\n'), rest_.size());
  const size_t to_lf = rest_.size() - from_next_lf_;
  return std::min(rest_.substr(0, to_lf).find('\r'), to_lf);
}

bool TextScanner::next_physical_line() {
  if (rest_.empty()) return false;
  steps_.take();
  const size_t length = line_length();
  line_ = rest_.substr(0, length);
  rest_.remove_prefix(length);
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<size_t>(1, rest_.size()));
  ++line_number_;
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
  if (at_line_end()) return {};
  steps_.take();
  size_t length = 0;
  while (length < line_.size() && !is_blank(line_[length])) ++length;
  const std::string_view token = line_.substr(0, length);
  line_.remove_prefix(length);
  return token;
}

bool TextScanner::at_line_end() {
  skip_blanks();
  while (line_.empty() && continues_ && next_physical_line()) skip_blanks();
  return line_.empty();
}

Status TextScanner::error(const std::string& what) const {
  return invalid_argument(name_ + ": line " + std::to_string(line_number_) + ": " + what);
}

/// Checks the lines of a piece that has one character for their ends. Counts them in `line`.
template <typename Check>
static Status for_long_lines(std::string_view rest, char end, size_t& line, FileSteps& steps,
                             const Check& check) {
  for (; rest.size() > kLineBytesMax; ++line) {
    steps.take();
    const size_t length = std::min(rest.find(end), rest.size());
    if (length > kLineBytesMax) RETURN_IF_ERROR(check(rest.substr(0, length)));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return Status::ok();
}

Status check_line_lengths(std::span<const uint8_t> bytes, const std::string& name,
                          FileSteps steps) {
  size_t line = 1;
  const auto refuse = [&](std::string_view text) {
    return invalid_argument(name + ": line " + std::to_string(line) + " has " +
                            std::to_string(text.size()) + " bytes, the limit is " +
                            std::to_string(kLineBytesMax));
  };
  return for_long_lines(as_text(bytes), '\n', line, steps, [&](std::string_view text) {
    return for_long_lines(text, '\r', line, steps, refuse);
  });
}

}  // namespace burnish
