#include "server/web/protocol/request_rules.h"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

const RequestRules kPlainRules{{"burnish.lab"}, false};
const RequestRules kTlsRules{{"burnish.lab"}, true};

bool takes_host(const std::string& host, const std::string& local_address = "10.0.0.7") {
  return check_host(kPlainRules, host, local_address).is_ok();
}

TEST(RequestRules, NamesOfThisServerAreTaken) {
  for (const char* host : {"localhost", "localhost:7443", "127.0.0.1:1", "127.8.9.1", "[::1]:7443",
                           "[::1]", "burnish.lab", "BURNISH.lab:7443", "10.0.0.7:7443"})
    EXPECT_TRUE(takes_host(host)) << host;
  EXPECT_TRUE(takes_host("[fe80::7]:80", "fe80::7"));
}

TEST(RequestRules, NamesOfThisMachineBeginAsItsHostName) {
  char name[256] = {};
  ASSERT_EQ(gethostname(name, sizeof name - 1), 0);
  const std::vector<std::string> names = names_of_this_machine();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), name);
  for (const std::string& each : names)
    EXPECT_TRUE(check_host({names, false}, each + ":7443", "10.0.0.7").is_ok()) << each;
}

TEST(RequestRules, ANameThatWasReboundToThisMachineIsRefused) {
  for (const char* host : {"", "evil.test", "evil.test:7443", "burnish.lab.evil.test",
                           "localhost.evil.test", "127.0.0.1.evil.test", "10.0.0.8", "localhost:",
                           "localhost:99999", "localhost:80:80", "[::1", "user@localhost"})
    EXPECT_FALSE(takes_host(host)) << host;
}

TEST(RequestRules, ARefusalShowsAHostAsOneShortLine) {
  const Status status = check_host(kPlainRules, "a\nb" + std::string(5000, 'c'), "10.0.0.7");
  EXPECT_EQ(status.code(), StatusCode::kPermissionDenied);
  EXPECT_THAT(status.message(), HasSubstr("'a?b"));
  EXPECT_LT(status.message().size(), 300u);
}

TEST(RequestRules, OnlyTheServersOwnPageHasTheRightOrigin) {
  EXPECT_TRUE(check_origin(kPlainRules, "http://burnish.lab:1", "burnish.lab:1").is_ok());
  EXPECT_TRUE(check_origin(kTlsRules, "https://burnish.lab:1", "Burnish.lab:1").is_ok());
  for (const char* origin : {"http://evil.test", "null", "http://burnish.lab", "burnish.lab:1",
                             "http://burnish.lab:1.evil.test", "http://burnish.lab:1/"})
    EXPECT_FALSE(check_origin(kPlainRules, origin, "burnish.lab:1").is_ok()) << origin;
}

TEST(RequestRules, AClientThatIsNotABrowserHasNoOrigin) {
  EXPECT_TRUE(check_origin(kTlsRules, "", "burnish.lab").is_ok());
}

TEST(RequestRules, APlainPageMustNotReachASocketWithTls) {
  EXPECT_FALSE(check_origin(kTlsRules, "http://burnish.lab", "burnish.lab").is_ok());
}

TEST(RequestRules, AProxyMayHaveTheTls) {
  EXPECT_TRUE(check_origin(kPlainRules, "https://burnish.lab", "burnish.lab").is_ok());
}

}  // namespace
}  // namespace burnish
