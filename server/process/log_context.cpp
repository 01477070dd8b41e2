#include "server/process/log_context.h"

#include <utility>

namespace burnish {

static thread_local std::string current_request;

const std::string& LogContext::current() {
  return current_request;
}

LogContext::LogContext(std::string request_id)
    : before_(std::exchange(current_request, std::move(request_id))) {}

LogContext::~LogContext() {
  current_request = std::move(before_);
}

}  // namespace burnish
