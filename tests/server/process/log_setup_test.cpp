#include "server/process/log_setup.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include "server/process/log_context.h"

namespace burnish {
namespace {

using nlohmann::json;

/// Returns one line of the formatter.
std::string written(std::unique_ptr<spdlog::formatter> formatter, const std::string& message) {
  std::ostringstream out;
  const auto sink = std::make_shared<spdlog::sinks::ostream_sink_st>(out);
  spdlog::logger log("test", sink);
  log.set_formatter(std::move(formatter));
  log.warn(message);
  return out.str();
}

TEST(JsonLog, ALineIsOneObjectWhateverTheMessage) {
  const std::string text = written(make_json_formatter(), "a \"b\"\nc \x01");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  const json line = json::parse(text);
  EXPECT_EQ(line["level"], "warning");
  EXPECT_EQ(line["message"], "a \"b\"?c ?");
  EXPECT_FALSE(line.contains("request"));
  EXPECT_THAT(line["time"].get<std::string>(), testing::EndsWith("Z"));
}

TEST(JsonLog, BytesThatAreNoUtf8AreReplaced) {
  const json line = json::parse(written(make_json_formatter(), "a\xff"));
  EXPECT_EQ(line["message"], "a?");
}

TEST(Log, AMessageForgesNoLineAndSpeaksToNoTerminal) {
  const std::string forged = "no session 'x\n[2026-01-01] [info] root logged in \x1b[31m\u202e'";
  for (auto* make : {&make_text_formatter, &make_json_formatter}) {
    const std::string text = written(make(), forged);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("\x1b")));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("\u202e")));
    EXPECT_THAT(text, testing::HasSubstr("no session 'x?[2026-01-01]"));
  }
}

TEST(Log, ALineIsNeverLong) {
  for (auto* make : {&make_text_formatter, &make_json_formatter}) {
    const std::string text = written(make(), std::string(15'000'000, 'x'));
    EXPECT_LT(text.size(), 1300u);
    EXPECT_THAT(text, testing::HasSubstr("... (14999000 more bytes)"));
  }
}

TEST(Log, CarriesTheRequestOfTheThread) {
  const LogContext outer("r1");
  EXPECT_EQ(json::parse(written(make_json_formatter(), "x"))["request"], "r1");
  {
    const LogContext inner("r2");
    EXPECT_THAT(written(make_text_formatter(), "x"), testing::EndsWith("] x [r2]\n"));
  }
  EXPECT_THAT(written(make_text_formatter(), "x"), testing::EndsWith("] x [r1]\n"));
}

}  // namespace
}  // namespace burnish
