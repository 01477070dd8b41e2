// What becomes of requests when a service fails in ways that a good one does not.

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/content_hash.h"
#include "server/s3/s3_upload.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/s3/misbehaving_service.h"
#include "tests/server/s3/s3_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string error(const std::string& code) {
  return "<?xml version='1.0'?>\n<Error><Code>" + code + "</Code></Error>";
}

S3Bucket bucket_of(const MisbehavingService& service) {
  return S3Bucket(S3Address::parse({"s3://bucket", service.endpoint()}).value(),
                  S3Service::credentials, short_patience());
}

Result<std::string> get(const S3Bucket& bucket, const Progress& progress = {}) {
  std::string all;
  const auto take = [&](std::string_view piece) {
    all += piece;
    return Status::ok();
  };
  RETURN_IF_ERROR(bucket.get("a", 1000, take, progress));
  return all;
}

TEST(S3Failures, AServiceThatIsBusyIsAskedAgain) {
  for (const auto& [status, code] : {std::pair(500, "InternalError"), std::pair(503, "SlowDown"),
                                     std::pair(429, "TooMany"), std::pair(400, "RequestTimeout")}) {
    std::atomic<int> count = 0;
    MisbehavingService service([&](const auto&) {
      return ++count < 3 ? FakeAnswer{status, error(code)} : FakeAnswer{200, "hello"};
    });
    EXPECT_EQ(get(bucket_of(service)).value(), "hello") << code;
    EXPECT_EQ(count, 3);
  }
}

TEST(S3Failures, AServiceThatStaysBusyIsGivenUpAfterFourTries) {
  const MisbehavingService service([](const auto&) { return FakeAnswer{503, error("SlowDown")}; });
  const Status failed = get(bucket_of(service)).status();
  EXPECT_EQ(failed.code(), StatusCode::kUnavailable);
  EXPECT_THAT(failed.message(), HasSubstr("GET s3://bucket/a: 503 SlowDown"));
  EXPECT_EQ(service.requests().size(), 4u);
}

TEST(S3Failures, ARefusalAndAMissingKeyAreNotTriedAgain) {
  for (const auto& [status, code] :
       {std::pair(403, StatusCode::kFailedPrecondition), std::pair(404, StatusCode::kNotFound),
        std::pair(400, StatusCode::kInternal), std::pair(413, StatusCode::kResourceExhausted)}) {
    const MisbehavingService service([status = status](const auto&) {
      return FakeAnswer{status, error("Word")};
    });
    EXPECT_EQ(get(bucket_of(service)).status().code(), code) << status;
    EXPECT_EQ(service.requests().size(), 1u);
  }
}

TEST(S3Failures, ABucketOfAnotherRegionSaysWhichOne) {
  const MisbehavingService service([](const auto&) {
    return FakeAnswer{.status = 301,
                      .body = error("PermanentRedirect"),
                      .more_headers = "x-amz-bucket-region: eu-west-3\r\n"};
  });
  const Status refused = bucket_of(service).check_access();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("eu-west-3"));
}

TEST(S3Failures, ABrokenDownloadGoesOnWhereItWas) {
  std::atomic<int> count = 0;
  MisbehavingService service([&](const auto&) {
    if (++count == 1) return FakeAnswer{200, "hel", 5};
    return FakeAnswer{206, "lo"};
  });
  EXPECT_EQ(get(bucket_of(service)).value(), "hello");
  EXPECT_THAT(service.requests()[0].headers, Not(HasSubstr("Range:")));
  EXPECT_THAT(service.requests()[1].headers, HasSubstr("Range: bytes=3-\r\n"));
}

TEST(S3Failures, AServiceWithoutRangesSendsAllAgainAndNothingIsDoubled) {
  std::atomic<int> count = 0;
  MisbehavingService service([&](const auto&) {
    return ++count == 1 ? FakeAnswer{200, "hel", 5} : FakeAnswer{200, "hello"};
  });
  EXPECT_EQ(get(bucket_of(service)).value(), "hello");
}

// The service has the clock: a second without bytes is the limit.
TEST(S3Failures, AServiceThatHangsInADownloadIsGivenUp) {
  const MisbehavingService service(
      [](const auto&) { return FakeAnswer{.body = "he", .body_bytes = 5, .hangs = true}; });
  const Status hung = get(bucket_of(service)).status();
  EXPECT_EQ(hung.code(), StatusCode::kUnavailable);
  EXPECT_THAT(hung.message(), HasSubstr("too slow"));
}

TEST(S3Failures, ACallerWhoGoesIsNotHeldByAServiceThatHangs) {
  const MisbehavingService service(
      [](const auto&) { return FakeAnswer{.body = "he", .body_bytes = 5, .hangs = true}; });
  const Status gone =
      get(bucket_of(service), [](std::string_view, double done) { return done == 0; }).status();
  EXPECT_EQ(gone.code(), StatusCode::kCancelled);
  EXPECT_EQ(service.requests().size(), 1u);
}

TEST(S3Failures, ACallerWhoGoesIsNotHeldByAPause) {
  const MisbehavingService service([](const auto&) { return FakeAnswer{503, error("SlowDown")}; });
  S3Patience patience = short_patience();
  patience.pause = std::chrono::hours(1);
  const S3Bucket bucket(S3Address::parse({"s3://bucket", service.endpoint()}).value(),
                        S3Service::credentials, patience);
  const Status gone =
      get(bucket, [](std::string_view phase, double) { return phase == "fetching"; }).status();
  EXPECT_EQ(gone.code(), StatusCode::kCancelled);
}

TEST(S3Failures, AnUploadWhoseEndFailsInsideAnAnswerOf200IsNotComplete) {
  const TemporaryFolder folder;
  const MisbehavingService service([](const MisbehavingService::Request& request) {
    if (request.line.find("uploads=") != std::string::npos)
      return FakeAnswer{.body = "<UploadId>x/+</UploadId>"};
    if (request.line.starts_with("PUT")) return FakeAnswer{.more_headers = "ETag: \"1\"\r\n"};
    return FakeAnswer{200, error("EntityTooSmall")};
  });
  const S3Bucket bucket = bucket_of(service);
  S3Upload upload = S3Upload::begin(bucket, "a").value();
  ContentHash hash;
  hash.update("hello");
  ASSERT_TRUE(upload.send(folder.write("file", "hello"), hash.finish(), {}).is_ok());
  EXPECT_THAT(upload.complete().message(), HasSubstr("EntityTooSmall"));
  EXPECT_THAT(service.requests()[1].line, HasSubstr("/bucket/a?partNumber=1&uploadId=x%2F%2B "));
  EXPECT_THAT(service.requests()[2].body, HasSubstr("<PartNumber>1</PartNumber><ETag>\"1\"<"));
}

TEST(S3Failures, AnAnswerWithoutAnUploadIdOrETagIsRefused) {
  const MisbehavingService service([](const auto&) { return FakeAnswer{.body = "nonsense"}; });
  EXPECT_EQ(S3Upload::begin(bucket_of(service), "a").status().code(), StatusCode::kInternal);
}

TEST(S3Failures, WordsOfAServiceDoNotReachTheLogAsTheyAre) {
  const MisbehavingService service([](const auto&) {
    return FakeAnswer{400, error("two\nlines")};
  });
  EXPECT_THAT(get(bucket_of(service)).status().message(), testing::EndsWith("400 Error"));
}

TEST(S3Failures, TheSecretIsInNoRequestAndTheTokenInEach) {
  const MisbehavingService service([](const auto&) { return FakeAnswer{200, "hello"}; });
  const S3Bucket bucket(
      S3Address::parse({"s3://bucket", service.endpoint()}).value(),
      [] {
        return S3Credentials{"me", "hidden", "of-a-day"};
      },
      short_patience());
  ASSERT_TRUE(get(bucket).is_ok());
  const std::string headers = service.requests()[0].headers;
  EXPECT_THAT(headers, Not(HasSubstr("hidden")));
  EXPECT_THAT(headers, HasSubstr("x-amz-security-token: of-a-day\r\n"));
  EXPECT_THAT(headers, HasSubstr(";x-amz-security-token")) << "it is signed";
}

}  // namespace
}  // namespace burnish
