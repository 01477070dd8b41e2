#include "client/model/documents/session_choice.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

ScanInfo scan_named(const std::string& name) {
  ScanInfo scan;
  scan.id = "id of " + name;
  scan.name = name;
  return scan;
}

SessionInfo session_of(const ScanInfo& scan, const std::string& name, int64_t created = 0) {
  SessionInfo session;
  session.name = name;
  session.scan_id = scan.id;
  session.created_unix_seconds = created;
  return session;
}

const ScanInfo kBunny = scan_named("bunny"), kHead = scan_named("head");

TEST(SessionChoice, TheFirstSessionHasTheNameOfItsScan) {
  const SessionWish wish = session_to_go_on(kBunny, {session_of(kHead, "head")}, {});
  EXPECT_EQ(wish.name, "bunny");
  EXPECT_EQ(wish.scan, kBunny.id);
}

TEST(SessionChoice, GoesOnInTheNewestSession) {
  const std::vector<SessionInfo> sessions = {
      session_of(kBunny, "old", 5), session_of(kBunny, "new", 7), session_of(kHead, "other", 9)};
  EXPECT_EQ(session_to_go_on(kBunny, sessions, {}).name, "new");
}

TEST(SessionChoice, TheSessionThatWasOpenLastComesBeforeTheNewest) {
  const std::vector<SessionInfo> sessions = {session_of(kBunny, "old", 5),
                                             session_of(kBunny, "new", 7)};
  EXPECT_EQ(session_to_go_on(kBunny, sessions, {"gone", "old", "new"}).name, "old");
}

TEST(SessionChoice, ANameThatIsTakenGetsANumber) {
  const std::vector<SessionInfo> sessions = {session_of(kHead, "bunny"),
                                             session_of(kHead, "bunny 2")};
  EXPECT_EQ(session_to_go_on(kBunny, sessions, {}).name, "bunny 3");
  EXPECT_EQ(new_session(kBunny, {session_of(kBunny, "bunny")}).name, "bunny 2");
}

TEST(SessionChoice, ADepthThatNoSessionHasBeginsANewOne) {
  SessionInfo coarse = session_of(kBunny, "bunny", 5);
  coarse.key.depth = 7;
  EXPECT_EQ(session_to_go_on(kBunny, {coarse}, {"bunny"}, 7).name, "bunny");
  const SessionWish fine = session_to_go_on(kBunny, {coarse}, {"bunny"}, 9);
  EXPECT_EQ(fine.name, "bunny 2");
  EXPECT_EQ(fine.key.depth, 9);
}

TEST(SessionChoice, ANameThatLooksLikeAnIdGetsANumber) {
  EXPECT_EQ(new_session(scan_named("0123456789abcdef"), {}).name, "0123456789abcdef 2");
}

}  // namespace
}  // namespace burnish
