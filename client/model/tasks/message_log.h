#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>

#include "common/base/status.h"

namespace burnish {

enum class Severity { kInfo, kWarning, kError };

struct Message {
  std::chrono::system_clock::time_point time;
  Severity severity = Severity::kInfo;
  std::string text;
};

inline constexpr size_t kMessagesKeptMax = 1000;

/// All messages to the user, oldest first.
class MessageLog {
 public:
  void add(Severity severity, std::string text) {
    messages_.push_back({std::chrono::system_clock::now(), severity, std::move(text)});
    if (messages_.size() <= kMessagesKeptMax) return;
    messages_.pop_front();
    ++dropped_;
  }
  void info(std::string text) { add(Severity::kInfo, std::move(text)); }
  void warning(std::string text) { add(Severity::kWarning, std::move(text)); }

  /// Reports why something failed. A cancellation is not an error.
  void failure(const std::string& what, const Status& status) {
    const bool is_cancelled = status.code() == StatusCode::kCancelled;
    add(is_cancelled ? Severity::kInfo : Severity::kError, what + ": " + status.message());
  }

  const std::deque<Message>& messages() const { return messages_; }
  /// Returns the number of the first of messages(), counted from 0 over all.
  uint64_t first_number() const { return dropped_; }

 private:
  std::deque<Message> messages_;
  uint64_t dropped_ = 0;
};

}  // namespace burnish
