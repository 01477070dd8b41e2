// Against a service that checks signatures and hashes.

#include "server/s3/s3_bucket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/s3/s3_service.h"
#include "tests/server/trust/test_certificates.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class S3BucketTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!S3Service::is_installed()) GTEST_SKIP() << S3Service::kMissing;
    service_ = std::make_unique<S3Service>();
    bucket_ = std::make_unique<S3Bucket>(service_->bucket(short_patience()));
  }

  static Result<std::string> get(const S3Bucket& bucket, const std::string& name,
                                 uint64_t bytes_max = 1000) {
    std::string all;
    const auto take = [&](std::string_view piece) {
      all += piece;
      return Status::ok();
    };
    RETURN_IF_ERROR(bucket.get(name, bytes_max, take, {}));
    return all;
  }
  Status refusal_of(const S3Credentials& credentials) const {
    return S3Bucket(
               service_->address(), [=] { return credentials; }, short_patience())
        .check_access();
  }

  std::unique_ptr<S3Service> service_;
  std::unique_ptr<S3Bucket> bucket_;
};

TEST_F(S3BucketTest, KeepsWhatIsPut) {
  ASSERT_TRUE(bucket_->put("a/b.txt", "hello").is_ok());
  EXPECT_EQ(bucket_->size_of("a/b.txt").value(), 5u);
  EXPECT_EQ(get(*bucket_, "a/b.txt").value(), "hello");
  ASSERT_TRUE(bucket_->put("a/b.txt", "").is_ok());
  EXPECT_EQ(get(*bucket_, "a/b.txt").value(), "");
}

TEST_F(S3BucketTest, GoesOnFromAByte) {
  ASSERT_TRUE(bucket_->put("a", "hello").is_ok());
  S3Request request{"GET", service_->address().key("a")};
  request.first_byte = 2;
  const auto rest = bucket_->send_quickly(request);
  ASSERT_TRUE(rest.is_ok()) << rest.status().message();
  EXPECT_EQ(rest->http, 206);
  EXPECT_EQ(rest->body, "llo");
}

TEST_F(S3BucketTest, DoesNotHaveWhatIsRemoved) {
  for (const char* name : {"a/1", "a/2", "b/1"}) ASSERT_TRUE(bucket_->put(name, "x").is_ok());
  ASSERT_TRUE(bucket_->remove_all("a/").is_ok());
  EXPECT_TRUE(bucket_->remove_all("a/").is_ok()) << "nothing is there";
  EXPECT_EQ(get(*bucket_, "a/1").status().code(), StatusCode::kNotFound);
  EXPECT_EQ(bucket_->size_of("a/2").status().code(), StatusCode::kNotFound);
  EXPECT_TRUE(get(*bucket_, "b/1").is_ok());
}

TEST_F(S3BucketTest, DoesNotReadMoreThanWanted) {
  ASSERT_TRUE(bucket_->put("a", "12345").is_ok());
  EXPECT_EQ(get(*bucket_, "a", 4).status().code(), StatusCode::kDataLoss);
}

TEST_F(S3BucketTest, IsTriedAtTheStartAndKeepsNothingOfThat) {
  EXPECT_TRUE(bucket_->check_access().is_ok());
  EXPECT_EQ(bucket_->size_of("probe").status().code(), StatusCode::kNotFound);
  S3Request uploads{"GET", ""};
  uploads.query = "uploads=";
  EXPECT_THAT(bucket_->send_quickly(uploads)->body, Not(HasSubstr("<UploadId>")));
}

TEST_F(S3BucketTest, AWrongSecretIsRefusedAndInNoMessage) {
  const Status refused = refusal_of({S3Service::kId, "another-secret", ""});
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), AllOf(HasSubstr("403 SignatureDoesNotMatch"),
                                       HasSubstr("s3://bucket"), Not(HasSubstr("secret"))));
  EXPECT_EQ(refusal_of({"lab:nobody", S3Service::kSecret, ""}).code(),
            StatusCode::kFailedPrecondition);
}

TEST_F(S3BucketTest, MayBeAPartOfTheHostsName) {
  ASSERT_TRUE(bucket_->put("a", "hello").is_ok());
  S3Settings settings = service_->settings();
  settings.endpoint.replace(settings.endpoint.find("127.0.0.1"), 9, "localhost");
  settings.addressing = "virtual";
  const S3Address address = S3Address::parse(settings).value();
  ASSERT_THAT(address.url(""), HasSubstr("http://bucket.localhost:"));
  const S3Bucket bucket(address, S3Service::credentials, short_patience());
  EXPECT_EQ(get(bucket, "a").value(), "hello");
  EXPECT_TRUE(bucket.check_access().is_ok());
}

TEST_F(S3BucketTest, CredentialsAreAskedForEachRequest) {
  std::string secret = "old";
  const S3Bucket bucket(
      service_->address(),
      [&] {
        return S3Credentials{S3Service::kId, secret, ""};
      },
      short_patience());
  EXPECT_FALSE(bucket.put("a", "x").is_ok());
  secret = S3Service::kSecret;
  EXPECT_TRUE(bucket.put("a", "x").is_ok());
}

TEST_F(S3BucketTest, AMissingBucketIsNotAMissingObject) {
  S3Settings settings = service_->settings();
  settings.uri = "s3://nowhere";
  const S3Bucket bucket(S3Address::parse(settings).value(), S3Service::credentials,
                        short_patience());
  const Status refused = bucket.check_access();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("404 NoSuchBucket"));
  EXPECT_EQ(get(bucket, "a").status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(S3BucketTest, AServiceThatIsGoneIsUnavailableAndWorksLater) {
  service_->kill();
  EXPECT_EQ(bucket_->check_access().code(), StatusCode::kUnavailable);
  service_->start();
  EXPECT_TRUE(bucket_->check_access().is_ok());
}

TEST_F(S3BucketTest, AServiceThatDiesInADownloadIsUnavailableAndWorksLater) {
  const std::string large(32 << 20, 'x');  // more than waits in sockets
  ASSERT_TRUE(bucket_->put("a", large).is_ok());
  uint64_t taken = 0;
  const auto take = [&](std::string_view piece) {
    if (taken == 0) service_->kill();
    taken += piece.size();
    return Status::ok();
  };
  EXPECT_EQ(bucket_->get("a", large.size(), take, {}).code(), StatusCode::kUnavailable);
  EXPECT_LT(taken, large.size());
  service_->start();
  ASSERT_TRUE(bucket_->put("b", "hello").is_ok());
  EXPECT_EQ(get(*bucket_, "b").value(), "hello");
}

TEST(S3BucketTls, NeedsAnAuthorityThatSignedTheCertificate) {
  if (!S3Service::is_installed()) GTEST_SKIP() << S3Service::kMissing;
  const TestCa ca("lab");
  const TestCa::Issued issued = ca.issue("s3.lab");
  const TemporaryFolder folder;
  const S3Service service(folder.write("server.pem", issued.certificate),
                          folder.write("server.key", issued.key));
  S3Settings settings = service.settings();
  const auto listed = [&] {
    return S3Bucket(S3Address::parse(settings).value(), S3Service::credentials, short_patience())
        .check_access();
  };
  EXPECT_EQ(listed().code(), StatusCode::kUnavailable);
  EXPECT_THAT(listed().message(), HasSubstr("certificate"));
  settings.ca = folder.write("ca.pem", ca.certificate());
  EXPECT_THAT(listed().message(), HasSubstr("NoSuchBucket")) << "it has none, and says so";
}

}  // namespace
}  // namespace burnish
