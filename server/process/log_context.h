#pragma once

#include <string>

namespace burnish {

/// The request that the current thread works for: every line of the log carries its id.
class LogContext {
 public:
  /// Returns the id of the thread's request; empty for none.
  static const std::string& current();

  /// Sets the id for a scope.
  explicit LogContext(std::string request_id);
  ~LogContext();
  LogContext(const LogContext&) = delete;
  LogContext& operator=(const LogContext&) = delete;

 private:
  std::string before_;
};

}  // namespace burnish
