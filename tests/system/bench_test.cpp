#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(BenchServe, FindsNothingLostByAGoodServer) {
  ServerProcess server;
  const std::string scan = write_sphere(server.folder, 4);
  ASSERT_EQ(server.burnish({"import", scan, "--depth", "5", "--name", "ball"}).exit_code, 0);
  for (const char* session : {"one", "two"})
    ASSERT_EQ(server.burnish({"open", "ball", "--depth", "5", "--session", session}).exit_code, 0);
  const CommandOutcome outcome =
      server.burnish({"bench", "serve", "--session", "one", "--session", "two", "--clients", "3",
                      "--seconds", "2", "--mix", "drag=1,paint=1", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  const auto report = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(report["clients"], 3);
  EXPECT_EQ(report["each"].size(), 3u);
  EXPECT_GT(report["edits_acknowledged"], 0);
  EXPECT_EQ(report["edits_missing_from_history"], 0);
  EXPECT_EQ(report["clients_agree"], true);
  EXPECT_EQ(report["replay_agrees"], true);
  EXPECT_GT(report["frame_age_ms"]["count"], 0);
  EXPECT_EQ(nlohmann::json::parse(server.burnish({"sessions", "--json"}).output).size(), 2u);
}

TEST(BenchServe, NamesWhatIsWrongWithItsOptions) {
  ServerProcess server;
  EXPECT_EQ(server.burnish({"bench"}).exit_code, 2);
  EXPECT_EQ(server.burnish({"bench", "serve"}).exit_code, 2);
  const CommandOutcome mix =
      server.burnish({"bench", "serve", "--session", "one", "--mix", "sing=1"});
  EXPECT_EQ(mix.exit_code, 2);
  EXPECT_THAT(mix.output, HasSubstr("sing=1"));
  const CommandOutcome none = server.burnish({"bench", "serve", "--session", "none"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.output, HasSubstr("none"));
}

}  // namespace
}  // namespace burnish
