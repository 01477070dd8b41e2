#pragma once

#include <memory>
#include <string>

#include <spdlog/formatter.h>

namespace burnish {

/// Sends the log to standard error. `level` is one of spdlog's; `format` is text or json.
void set_up_log(const std::string& level, const std::string& format);

/// Both write a message as one line of at most 1,000 bytes, with '?' for what a terminal obeys and
/// for bytes that are no UTF-8.

/// One JSON object a line: time, level, request (where there is one), message.
std::unique_ptr<spdlog::formatter> make_json_formatter();

/// "[time] [level] message [request]".
std::unique_ptr<spdlog::formatter> make_text_formatter();

}  // namespace burnish
