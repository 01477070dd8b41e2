#include "server/s3/s3_address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string url(const S3Settings& settings) {
  const S3Address address = S3Address::parse(settings).value();
  return address.url(address.key("a.ply"));
}

std::string problem(const S3Settings& settings) {
  const Status status = S3Address::parse(settings).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << settings.uri;
  return status.message();
}

TEST(S3Address, AwsHasTheBucketInTheHostAndOthersInThePath) {
  EXPECT_EQ(url({.uri = "s3://scans"}), "https://scans.s3.us-east-1.amazonaws.com/a.ply");
  EXPECT_EQ(url({.uri = "s3://scans", .region = "eu-west-3"}),
            "https://scans.s3.eu-west-3.amazonaws.com/a.ply");
  EXPECT_EQ(url({.uri = "s3://scans/lab/x/", .endpoint = "http://[::1]:9000"}),
            "http://[::1]:9000/scans/lab/x/a.ply");
  EXPECT_EQ(url({.uri = "s3://sc.ans"}), "https://s3.us-east-1.amazonaws.com/sc.ans/a.ply")
      << "AWS's certificate has no name with one more dot";
}

TEST(S3Address, TheSettingDecidesWhereTheBucketIs) {
  EXPECT_EQ(url({.uri = "s3://scans", .endpoint = "https://s3.lab", .addressing = "virtual"}),
            "https://scans.s3.lab/a.ply");
  EXPECT_EQ(url({.uri = "s3://scans", .addressing = "path"}),
            "https://s3.us-east-1.amazonaws.com/scans/a.ply");
}

TEST(S3Address, WhatIsNotABucketIsRefused) {
  for (const char* bucket : {"s3://", "s3://ab", "s3://Scans", "s3://-scans", "s3://sc ans"})
    EXPECT_THAT(problem({.uri = bucket}), HasSubstr("bucket '")) << bucket;
  for (const char* prefix : {"a//b", "a/../b", "../b", "a?b", "a%2Fb", "./a"})
    EXPECT_THAT(problem({.uri = std::string("s3://scans/") + prefix}), HasSubstr("prefix '"));
  EXPECT_THAT(problem({.uri = "s3://scans", .region = "eu west"}), HasSubstr("'eu west'"));
}

TEST(S3Address, AnEndpointHasNoUserAndNoPathAndIsNotRepeated) {
  for (const char* endpoint : {"s3.lab:9000", "ftp://s3.lab", "http://", "https://s3.lab/x",
                               "https://me:password@s3.lab", "https://s3.lab?password"})
    EXPECT_THAT(problem({.uri = "s3://scans", .endpoint = endpoint}),
                testing::AllOf(HasSubstr("library.s3_endpoint"), Not(HasSubstr("password"))))
        << endpoint;
}

TEST(S3Address, LettersThatMeanSomethingInAQueryAreEncoded) {
  EXPECT_EQ(percent_encoded("aZ09-_.~ /+=&\xc3"), "aZ09-_.~%20%2F%2B%3D%26%C3");
}

}  // namespace
}  // namespace burnish
