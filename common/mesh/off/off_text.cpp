#include "common/mesh/off/off_text.h"

#include <optional>

#include "common/base/limits.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

Status OffText::read_header() {
  std::string_view counts;
  RETURN_IF_ERROR(read_magic(counts));
  RETURN_IF_ERROR(read_counts(counts));
  RETURN_IF_ERROR(check_size());
  lines_ = count_lines();
  return Status::ok();
}

/// Leaves in `counts` what follows the first word without a blank: some programs write OFF144.
Status OffText::read_magic(std::string_view& counts) {
  const std::string_view word = scanner_.next_line() ? scanner_.next_token() : "";
  counts = word;
  const std::optional<OffKind> kind = take_off_kind(counts);
  if (!kind || (!counts.empty() && !is_digit(counts[0])))
    return scanner_.error("not an OFF file: begins with " + in_quotes(word) +
                          ", not OFF, COFF, NOFF or CNOFF");
  kind_ = *kind;
  return Status::ok();
}

/// Reads "vertices faces [edges]", after the first word or on lines of their own.
Status OffText::read_counts(std::string_view counts) {
  const auto next = [&] {
    const std::string_view token = scanner_.next_token();
    return token.empty() && scanner_.next_line() ? scanner_.next_token() : token;
  };
  const std::string_view token = counts.empty() ? next() : counts;
  if (token == "BINARY") return scanner_.error("binary OFF files cannot be read; only text");
  RETURN_IF_ERROR(parse_count("vertex", token, kVerticesMax, vertices_));
  RETURN_IF_ERROR(parse_count("face", next(), kTrianglesMax, faces_));
  skip_edges();
  return Status::ok();
}

Status OffText::parse_count(const std::string& what, std::string_view token, uint64_t limit,
                            uint64_t& count) const {
  int64_t value;
  if (!parse_integer(token, value))
    return scanner_.error("the " + what + " count " + in_quotes(token) + " is not a count");
  if (value < 0 || static_cast<uint64_t>(value) > limit)
    return scanner_.error("the " + what + " count " + std::to_string(value) + " is outside 0 to " +
                          std::to_string(limit));
  count = static_cast<uint64_t>(value);
  return Status::ok();
}

/// The shortest vertex is "0 0 0" and the shortest face "0"; all but the last have a blank or an
/// end of a line behind them.
Status OffText::check_size() const {
  const uint64_t bytes_min = 6 * vertices_ + 2 * faces_;
  const uint64_t bytes = scanner_.line_rest().size() + scanner_.bytes_after_line();
  if (bytes_min <= bytes + 1) return Status::ok();
  return scanner_.error("the header promises " + std::to_string(vertices_) + " vertices and " +
                        std::to_string(faces_) + " faces, at least " +
                        std::to_string(bytes_min - 1) + " bytes, but only " +
                        std::to_string(bytes) + " follow");
}

/// The number of edges may be missing, or be the only word of a line.
void OffText::skip_edges() {
  if (!scanner_.next_token().empty()) return;
  TextScanner ahead = scanner_;
  if (ahead.next_line() && !ahead.next_token().empty() && ahead.at_line_end()) scanner_ = ahead;
}

OffText::Lines OffText::count_lines() const {
  const uint64_t elements = vertices_ + faces_;
  uint64_t lines = 0;
  for (TextScanner ahead = scanner_; lines <= elements && ahead.next_line();) ++lines;
  if (lines == elements) return Lines::kOneEach;
  return lines > elements ? Lines::kSeveralEach : Lines::kShared;
}

bool OffText::next_element() {
  if (lines_ == Lines::kShared && !scanner_.at_line_end()) return true;
  return scanner_.next_line();
}

std::string_view OffText::next_word() {
  const std::string_view word = scanner_.next_token();
  if (!word.empty() || lines_ == Lines::kOneEach || !scanner_.next_line()) return word;
  return scanner_.next_token();
}

}  // namespace burnish
