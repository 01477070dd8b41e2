#include "server/process/log_setup.h"

#include <nlohmann/json.hpp>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "common/base/text.h"
#include "server/process/log_context.h"

namespace burnish {
namespace {

constexpr size_t kMessageBytesMax = 1000;

// Makes every line safe: names and references come from clients, and so do the bytes of some lines.
std::string message_of(const spdlog::details::log_msg& message) {
  return one_line({message.payload.data(), message.payload.size()}, kMessageBytesMax);
}

/// "%!" in a pattern: the message.
class MessageFlag final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& line) override {
    const std::string text = message_of(message);
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<MessageFlag>();
  }
};

/// "%*" in a pattern: " [request]", or nothing.
class RequestFlag final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg&, const std::tm&,
              spdlog::memory_buf_t& line) override {
    const std::string& request = LogContext::current();
    if (request.empty()) return;
    const std::string text = " [" + request + "]";
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<custom_flag_formatter> clone() const override {
    return std::make_unique<RequestFlag>();
  }
};

class JsonFormatter final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& line) override {
    spdlog::memory_buf_t time;
    time_.format(message, time);
    const auto level = spdlog::level::to_string_view(message.level);
    nlohmann::ordered_json json;
    json["time"] = std::string(time.data(), time.size());
    json["level"] = std::string(level.data(), level.size());
    if (!LogContext::current().empty()) json["request"] = LogContext::current();
    json["message"] = message_of(message);
    const std::string text = json.dump() + "\n";
    line.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<JsonFormatter>();
  }

 private:
  spdlog::pattern_formatter time_{"%Y-%m-%dT%H:%M:%S.%fZ", spdlog::pattern_time_type::utc, ""};
};

}  // namespace

std::unique_ptr<spdlog::formatter> make_json_formatter() {
  return std::make_unique<JsonFormatter>();
}

std::unique_ptr<spdlog::formatter> make_text_formatter() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<RequestFlag>('*').add_flag<MessageFlag>('!').set_pattern(
      "[%Y-%m-%d %H:%M:%S.%e] [%^%l%$] %!%*");
  return formatter;
}

void set_up_log(const std::string& level, const std::string& format) {
  const auto log = spdlog::stderr_color_mt("burnish-server");
  log->set_formatter(format == "json" ? make_json_formatter() : make_text_formatter());
  spdlog::set_default_logger(log);
  spdlog::set_level(spdlog::level::from_str(level));
}

}  // namespace burnish
