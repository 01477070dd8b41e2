// The page's files as a browser gets them from a real server.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/web_client.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class WebPages : public testing::Test {
 protected:
  std::string get(const std::string& target, const std::string& headers = {}) const {
    const std::string address = web_address(server_);
    return http_exchange(address, "GET " + target + " HTTP/1.1\r\nHost: " + address + "\r\n" +
                                      headers + "Connection: close\r\n\r\n");
  }

  /// Returns a header's value.
  static std::string value_of(const std::string& answer, const std::string& name) {
    const size_t begin = answer.find("\r\n" + name + ": ") + name.size() + 4;
    return answer.substr(begin, answer.find('\r', begin) - begin);
  }

  ServerProcess server_{{"--web", "127.0.0.1:0"}};
};

TEST_F(WebPages, TheIndexNamesAssetsThatAreThere) {
  const std::string index = get("/");
  EXPECT_THAT(index, StartsWith("HTTP/1.1 200 OK\r\n"));
  EXPECT_THAT(index, HasSubstr("Content-Security-Policy: default-src 'none'"));
  for (const char* kind : {"href=\"assets/", "src=\"assets/", "href=\"favicon"}) {
    const size_t begin = index.find('"', index.find(kind)) + 1;
    const std::string target = "/" + index.substr(begin, index.find('"', begin) - begin);
    EXPECT_THAT(get(target), StartsWith("HTTP/1.1 200 OK\r\n")) << target;
  }
}

TEST_F(WebPages, ATagThatTheBrowserHasSavesTheBody) {
  const std::string tag = value_of(get("/"), "ETag");
  const std::string again = get("/", "If-None-Match: " + tag + "\r\n");
  EXPECT_THAT(again, StartsWith("HTTP/1.1 304"));
  EXPECT_THAT(again, testing::EndsWith("\r\n\r\n"));
}

TEST_F(WebPages, AFileGoesOutPacked) {
  const std::string packed = get("/", "Accept-Encoding: gzip\r\n");
  EXPECT_EQ(value_of(packed, "Content-Encoding"), "gzip");
  EXPECT_THAT(packed, HasSubstr("\r\n\r\n\x1f\x8b"));
  EXPECT_THAT(packed, Not(HasSubstr("<html")));
}

TEST_F(WebPages, OneConnectionServesSeveralRequests) {
  const std::string address = web_address(server_);
  const std::string head = " / HTTP/1.1\r\nHost: " + address + "\r\n";
  const std::string answer =
      http_exchange(address, "HEAD" + head + "\r\nHEAD" + head + "Connection: close\r\n\r\n");
  const size_t second = answer.find("HTTP/1.1 200", 1);
  EXPECT_NE(second, std::string::npos);
  EXPECT_THAT(answer, Not(HasSubstr("<html")));
}

}  // namespace
}  // namespace burnish
