#pragma once

#include <memory>
#include <string>

#include <spdlog/formatter.h>

namespace burnish {

/// Sends the log to standard error. `level` is a level of spdlog; `format` is text or json.
void set_up_log(const std::string& level, const std::string& format);

/// Both write a message as one line of at most 1,000 bytes. They write '?' for characters that
/// control a terminal and for bytes that are not UTF-8.

/// Writes one JSON object per line: time, level, request (if there is one), message.
std::unique_ptr<spdlog::formatter> make_json_formatter();

/// Writes "[time] [level] message [request]".
std::unique_ptr<spdlog::formatter> make_text_formatter();

}  // namespace burnish
