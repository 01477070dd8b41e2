#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "common/mesh/ply/ply_header.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

/// Reads the values of a text PLY body; has the same interface as PlyBinarySource. An element may
/// take several lines (long strips do), but a line holds at most one element.
class PlyAsciiSource {
 public:
  PlyAsciiSource(std::span<const uint8_t> bytes, const PlyHeader& header, const std::string& name,
                 const FileSteps& steps = {})
      : scanner_(bytes.subspan(header.body_offset), name, {}, header.lines, steps) {}

  /// Returns false at the end of the file, or if the token is not a number of the type's kind.
  bool read(PlyType type, double& value) {
    token_ = scanner_.next_token();
    if (token_.empty() && scanner_.next_line()) token_ = scanner_.next_token();
    if (!is_integer(type)) return parse_double(token_, value);
    int64_t integer;
    if (!parse_integer(token_, integer)) return false;
    value = static_cast<double>(integer);
    return true;
  }

  bool skip(PlyType type, uint64_t count) {
    double ignored;
    for (uint64_t i = 0; i < count; ++i)
      if (!read(type, ignored)) return false;
    return true;
  }

  /// Counts a digit and a blank for each value; the last needs no blank.
  uint64_t values_left_max(PlyType) const {
    return (scanner_.line_rest().size() + scanner_.bytes_after_line()) / 2 + 1;
  }

  bool at_line_end() {
    token_ = scanner_.next_token();
    return token_.empty();
  }

  bool last_exceeds_float(double value) const { return exceeds_float(token_, value); }

  /// Returns the text of the last value, inside the file's bytes.
  std::string_view last_bytes() const { return token_; }

  std::string failure() const {
    if (token_.empty()) return "the file ends inside it";
    return in_quotes(token_) + " is not a value of the declared type";
  }

  Status error(const std::string& what) const { return scanner_.error(what); }

 private:
  TextScanner scanner_;
  std::string_view token_;  // the last token
};

}  // namespace burnish
