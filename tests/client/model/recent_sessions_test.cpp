#include "client/model/settings/recent_sessions.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

RecentSession recent_of(const std::string& session, const std::string& id = "") {
  return {.session = session, .id = id};
}

SessionInfo named(const std::string& id, const std::string& name) {
  SessionInfo session;
  session.id = id;
  session.name = name;
  session.scan_id = "scan";
  return session;
}

TEST(RecentSessions, ASessionIsRememberedOnceAndTheOldestIsForgotten) {
  std::vector<RecentSession> recent;
  for (int i = 0; i < 20; ++i) remember(recent, recent_of(std::to_string(i)));
  remember(recent, recent_of("15"));
  EXPECT_EQ(recent.size(), kRecentMax);
  EXPECT_EQ(recent[0].session, "15");
  EXPECT_EQ(recent[1].session, "19");
}

TEST(RecentSessions, ASessionWithANewNameStaysOneEntry) {
  std::vector<RecentSession> recent;
  remember(recent, recent_of("desk", "id"));
  remember(recent, recent_of("table", "id"));
  ASSERT_EQ(recent.size(), 1u);
  EXPECT_EQ(recent[0].session, "table");
}

TEST(RecentSessions, NamesFollowTheirServerAlone) {
  std::vector<RecentSession> recent = {recent_of("desk", "id"), recent_of("desk", "id")};
  recent[1].server = "host:1";
  recent[0].scan = "scan";
  ScanInfo scan;
  scan.id = "scan";
  scan.name = "stone";
  scan.size_bytes = 5;
  scan.prepared = {{{}, 7}};
  EXPECT_TRUE(follow_names(recent, "", {named("id", "table")}, {scan}));
  EXPECT_EQ(recent[0].session, "table");
  EXPECT_EQ(recent[0].scan_name, "stone");
  EXPECT_EQ(recent[0].size_bytes, 12u);
  EXPECT_EQ(recent[1].session, "desk");
  EXPECT_FALSE(follow_names(recent, "", {named("id", "table")}, {scan}));
}

TEST(RecentSessions, ARenamedSessionIsFoundByItsId) {
  EXPECT_EQ(session_of_recent(recent_of("desk", "id"), {named("id", "table")}).name, "table");
}

TEST(RecentSessions, AnotherSessionWithTheOldNameIsNotTakenForIt) {
  const std::vector<SessionInfo> sessions = {named("new", "desk"), named("id", "table")};
  EXPECT_EQ(session_of_recent(recent_of("desk", "id"), sessions).name, "table");
}

TEST(RecentSessions, ASessionThatIsGoneKeepsItsNameAndScan) {
  RecentSession recent = recent_of("desk", "id");
  recent.scan = "scan";
  const SessionWish wish = session_of_recent(recent, {});
  EXPECT_EQ(wish.name, "desk");
  EXPECT_EQ(wish.scan, "scan");
}

}  // namespace
}  // namespace burnish
