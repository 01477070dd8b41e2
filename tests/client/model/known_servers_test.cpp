#include "client/model/settings/known_servers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(KnownServers, AServerIsRememberedOnceAndTheOldestIsForgotten) {
  std::vector<KnownServer> servers;
  for (int i = 0; i < 20; ++i) remember_server(servers, {.address = std::to_string(i)});
  remember_server(servers, {.address = "18", .user = "ada"});
  EXPECT_EQ(servers.size(), kKnownServersMax);
  EXPECT_EQ(servers[0].user, "ada");
  EXPECT_EQ(servers[1].address, "19");
}

TEST(KnownServers, AServerThatIsNotKnownHasItsAddressAlone) {
  EXPECT_EQ(server_at({{.address = "a:1", .tls = true}}, "b:1"), KnownServer{.address = "b:1"});
  EXPECT_TRUE(server_at({{.address = "a:1", .tls = true}}, "a:1").tls);
}

TEST(KnownServers, WhatIsKnownComesBeforeTheUsualTrust) {
  const ConnectionTrust usual{.ca = "/lab.pem", .token = "abc"};
  EXPECT_EQ(trust_in({.address = "a:1"}, usual).token, "abc");
  EXPECT_EQ(trust_in({.address = "a:1", .token = "def"}, usual).token, "def");
  EXPECT_EQ(trust_in({.address = "a:1"}, usual).ca, "/lab.pem");
}

TEST(KnownServers, AFormAndItsServerAreTheSame) {
  const TemporaryFolder folder;
  const KnownServer server{.address = "[::1]:7000",
                           .tls = true,
                           .ca = folder.write("ca.pem", "x"),
                           .user = "ada",
                           .token = "abc",
                           .keeps_token = true};
  EXPECT_TRUE(problems_of(form_of(server)).has_none());
  EXPECT_EQ(server_of(form_of(server)), server);
}

TEST(KnownServers, EachFieldThatIsWrongIsNamedWithItsValue) {
  ConnectionForm form;
  form.port = "70000";
  form.ca = "/nowhere/ca.pem";
  form.token = "two words";
  const FormProblems problems = problems_of(form);
  EXPECT_FALSE(problems.host.empty());
  EXPECT_THAT(problems.port, testing::AllOf(HasSubstr("70000"), HasSubstr("65535")));
  EXPECT_THAT(problems.ca, HasSubstr("/nowhere/ca.pem"));
  EXPECT_FALSE(problems.token.empty());
  form.host = "burnish.lab:7411";
  EXPECT_THAT(problems_of(form).host, HasSubstr("burnish.lab:7411"));
}

}  // namespace
}  // namespace burnish
