#pragma once

#include <string>

namespace burnish {

/// Whose request the current thread works for: its id, which every line of the log then carries.
class LogContext {
 public:
  /// The id of the thread's request; empty: none.
  static const std::string& current();

  /// Sets it for a scope.
  explicit LogContext(std::string request_id);
  ~LogContext();
  LogContext(const LogContext&) = delete;
  LogContext& operator=(const LogContext&) = delete;

 private:
  std::string before_;
};

}  // namespace burnish
