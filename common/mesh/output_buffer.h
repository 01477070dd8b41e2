#pragma once

#include <algorithm>
#include <charconv>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/atomic_file.h"
#include "common/base/file_budget.h"
#include "common/base/status.h"

namespace burnish {

/// Takes the bytes of a file in their order.
using ByteSink = std::function<Status(std::string_view)>;

/// Gathers small values into large writes. Keeps the first failure for flush() and drops later
/// values. Asks a budget for 0 bytes before each large write; it throws WorkCancelled if that
/// fails.
class OutputBuffer {
 public:
  explicit OutputBuffer(AtomicFile& file, FileBudget budget = {})
      : OutputBuffer([&file](std::string_view text) { return file.write(text); },
                     std::move(budget)) {}
  explicit OutputBuffer(ByteSink sink, FileBudget budget = {})
      : sink_(std::move(sink)), budget_(std::move(budget)) {
    buffer_.reserve(kBytes);
  }

  /// Hears of loops that write nothing yet.
  const FileBudget& budget() const { return budget_; }

  void put_text(std::string_view text) {
    if (buffer_.size() + text.size() > kBytes) write();
    if (text.size() > kBytes) return send(text);
    buffer_.append(text);
  }

  /// Appends the bytes of a value in the machine's order, which is little-endian.
  template <typename T>
  void put_bytes(const T& value) {
    put_text({reinterpret_cast<const char*>(&value), sizeof value});
  }

  /// Appends the shortest decimal number that reads back as the same value.
  template <typename Number>
  void put_number(Number value) {
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    put_text({text, static_cast<size_t>(result.ptr - text)});
  }

  /// Writes the rest. Returns the first failure. Call last.
  Status flush() {
    write();
    return status_;
  }

 private:
  static constexpr size_t kBytes = 1 << 20;

  void send(std::string_view text) {
    constexpr size_t kPieceBytes = 16 * kBytes;
    for (; !text.empty() && status_.is_ok();
         text.remove_prefix(std::min(text.size(), kPieceBytes))) {
      if (!hear(budget_).is_ok()) leave_cancelled_work();
      status_ = sink_(text.substr(0, kPieceBytes));
    }
  }

  void write() {
    send(buffer_);
    buffer_.clear();
  }

  ByteSink sink_;
  FileBudget budget_;
  std::string buffer_;
  Status status_;
};

}  // namespace burnish
