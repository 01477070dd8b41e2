// Undo, history, forks and roles with the program's commands, across a killed server.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/system/server_process.h"

namespace burnish {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A server with a session "work" that ann has opened.
class People : public testing::Test {
 protected:
  People() {
    done({"import", write_sphere(server_.folder), "--depth", "4", "--name", "ball"});
    done({"open", "ball", "--depth", "4", "--session", "work", "--user", "ann"});
  }

  std::string done(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return outcome.output;
  }

  json done_json(std::vector<std::string> words) {
    words.push_back("--json");
    const std::string output = done(std::move(words));
    return json::parse(output.substr(output.find_first_of("[{")));
  }

  std::string refused(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
    return outcome.output;
  }

  ServerProcess server_;
};

TEST_F(People, EachUndoesTheirOwnAlsoOnAServerThatWasKilled) {
  done({"edit", "work", "--beta", "0.25", "--user", "ann"});
  done({"edit", "work", "--beta", "0.5", "--user", "bob"});
  EXPECT_THAT(done({"undo", "work", "--user", "ann"}), HasSubstr("undone 1: beta 0.25"));
  server_.kill();
  server_.start();
  const json history = done_json({"history", "work"});
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0]["author"], "ann");
  EXPECT_EQ(history[0]["enabled"], false);
  EXPECT_EQ(history[1]["enabled"], true);
  EXPECT_THAT(refused({"undo", "work", "--user", "ann"}), HasSubstr("no edit to undo"));
  EXPECT_THAT(done({"redo", "work", "--user", "ann"}), HasSubstr("redone 1: beta 0.25"));
  done({"history", "work", "--off", "2", "--user", "eve"});
  EXPECT_EQ(done_json({"sessions", "work"})["beta"], 0.25);
}

TEST_F(People, ACheckpointIsRestoredAndForkedFrom) {
  done({"edit", "work", "--beta", "0.25"});
  EXPECT_THAT(done({"checkpoint", "work", "before lunch"}), HasSubstr("set 2: before lunch"));
  done({"edit", "work", "--beta", "0.5"});
  EXPECT_THAT(done({"fork", "work", "--session", "copy", "--checkpoint", "before lunch"}),
              HasSubstr("forked work: copy, 2 edits"));
  EXPECT_EQ(done_json({"sessions", "copy"})["beta"], 0.25);
  done({"checkpoint", "work", "before lunch", "--restore"});
  EXPECT_EQ(done_json({"sessions", "work"})["beta"], 0.25);
  EXPECT_THAT(refused({"checkpoint", "work", "after lunch", "--restore"}),
              HasSubstr("no checkpoint has the name 'after lunch'"));
}

TEST_F(People, AViewerLooksAndDoesNotEdit) {
  done({"people", "work", "--give", "bob", "--role", "viewer", "--user", "ann"});
  EXPECT_THAT(refused({"edit", "work", "--beta", "0", "--user", "bob"}),
              HasSubstr("'bob' is viewer"));
  done({"history", "work", "--user", "bob"});
  EXPECT_THAT(refused({"people", "work", "--others", "--role", "owner", "--user", "bob"}),
              HasSubstr("giving roles needs the role owner"));
  EXPECT_THAT(refused({"close", "work", "--delete", "--user", "bob"}), HasSubstr("needs the role"));
  const json people = done_json({"people", "work"});
  EXPECT_EQ(people["roles"]["ann"], "owner");
  EXPECT_EQ(people["roles"]["bob"], "viewer");
  EXPECT_EQ(people["roles"][""], "editor");
}

}  // namespace
}  // namespace burnish
