// Against a service that checks signatures and hashes.

#include "server/s3/s3_upload.h"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/content_hash.h"
#include "tests/server/s3/s3_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class S3UploadTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!S3Service::is_installed()) GTEST_SKIP() << S3Service::kMissing;
    service_ = std::make_unique<S3Service>();
    bucket_ = std::make_unique<S3Bucket>(service_->bucket(short_patience()));
    for (int i = 0; i < 35'000; ++i) text_ += static_cast<char>('a' + i * 7 % 26);
    file_ = folder_.write("file", text_);
  }

  static std::string hash_of(const std::string& text) {
    ContentHash hash;
    hash.update(text);
    return hash.finish();
  }
  Status send(S3Upload& upload, const Progress& progress = {}) const {
    return upload.send(file_, hash_of(text_), progress);
  }
  std::string content() const {
    std::string all;
    const auto take = [&](std::string_view piece) {
      all += piece;
      return Status::ok();
    };
    return bucket_->get("a", 1 << 20, take, {}).is_ok() ? all : "";
  }
  /// Returns whether the service still has parts that belong to no object.
  bool has_parts() const {
    S3Request uploads{"GET", ""};
    uploads.query = "uploads=";
    return bucket_->send_quickly(uploads)->body.find("<UploadId>") != std::string::npos;
  }

  const TemporaryFolder folder_;
  std::filesystem::path file_;
  std::string text_;
  std::unique_ptr<S3Service> service_;
  std::unique_ptr<S3Bucket> bucket_;
};

TEST_F(S3UploadTest, AFileOfSeveralPartsAppearsAtOnce) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  double last = 0;
  ASSERT_TRUE(send(upload, [&](std::string_view, double fraction) {
                EXPECT_LE(fraction, 1);
                last = std::max(last, fraction);
                return true;
              }).is_ok());
  EXPECT_GT(last, 0.5);
  EXPECT_EQ(bucket_->size_of("a").status().code(), StatusCode::kNotFound);
  ASSERT_TRUE(upload.complete().is_ok());
  EXPECT_EQ(content(), text_);
  EXPECT_FALSE(has_parts());
}

TEST_F(S3UploadTest, AFileOfOnePartAppearsToo) {
  text_ = "short";
  folder_.write("file", text_);
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  ASSERT_TRUE(send(upload).is_ok());
  ASSERT_TRUE(upload.complete().is_ok());
  EXPECT_EQ(content(), "short");
}

TEST_F(S3UploadTest, TakesThePlaceOfWhatIsThere) {
  ASSERT_TRUE(bucket_->put("a", "damaged").is_ok());
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  ASSERT_TRUE(send(upload).is_ok());
  EXPECT_EQ(content(), "damaged");
  ASSERT_TRUE(upload.complete().is_ok());
  EXPECT_EQ(content(), text_);
}

TEST_F(S3UploadTest, WithoutAnEndLeavesNothing) {
  {
    S3Upload upload = S3Upload::begin(*bucket_, "a").value();
    ASSERT_TRUE(send(upload).is_ok());
    EXPECT_TRUE(has_parts());
  }
  EXPECT_FALSE(has_parts());
  EXPECT_EQ(content(), "");
}

TEST_F(S3UploadTest, AnotherFileThanTheOneNamedIsDataLoss) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  EXPECT_EQ(upload.send(file_, hash_of("x"), {}).code(), StatusCode::kDataLoss);
  EXPECT_EQ(upload.send(folder_ / "none", hash_of("x"), {}).code(), StatusCode::kNotFound);
}

TEST_F(S3UploadTest, ACompletedUploadIsUnknownTheSecondTime) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  ASSERT_TRUE(send(upload).is_ok());
  S3Upload copy = S3Upload::begin(*bucket_, "a").value();
  ASSERT_TRUE(send(copy).is_ok());
  ASSERT_TRUE(upload.complete().is_ok());
  ASSERT_TRUE(copy.complete().is_ok()) << "the later one counts";
  EXPECT_EQ(content(), text_);
  EXPECT_TRUE(upload.abort().is_ok());
}

TEST_F(S3UploadTest, ThatSomebodyHasEndedMayBeTriedAgain) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  const std::string key = service_->address().key("a");
  S3Request uploads{"GET", ""};
  uploads.query = "uploads=";
  const std::string id = xml_text(bucket_->send_quickly(uploads)->body, "UploadId");
  S3Request end{"DELETE", key};
  end.query = "uploadId=" + id;
  ASSERT_TRUE(bucket_->send_quickly(end).is_ok());
  EXPECT_EQ(send(upload).code(), StatusCode::kUnavailable);
  EXPECT_TRUE(upload.abort().is_ok()) << "it is over";
}

TEST_F(S3UploadTest, IsCancelledWithinAPart) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  EXPECT_EQ(send(upload, [](std::string_view, double) { return false; }).code(),
            StatusCode::kCancelled);
}

TEST_F(S3UploadTest, AServiceThatDiesInItIsUnavailableAndNothingHalfIsSeenLater) {
  {
    S3Upload upload = S3Upload::begin(*bucket_, "a").value();
    const Status cut = send(upload, [&](std::string_view, double fraction) {
      if (fraction > 0.4) service_->kill();
      return true;
    });
    EXPECT_EQ(cut.code(), StatusCode::kUnavailable) << cut.message();
  }
  service_->start();
  EXPECT_EQ(content(), "");
  S3Upload again = S3Upload::begin(*bucket_, "a").value();
  ASSERT_TRUE(send(again).is_ok());
  ASSERT_TRUE(again.complete().is_ok());
  EXPECT_EQ(content(), text_);
}

// The service has the clock: it stands still, and a second without bytes is the limit.
TEST_F(S3UploadTest, AServiceThatHangsIsGivenUp) {
  S3Upload upload = S3Upload::begin(*bucket_, "a").value();
  const Status hung = send(upload, [&](std::string_view, double fraction) {
    if (fraction > 0.4) service_->signal(SIGSTOP);
    return true;
  });
  EXPECT_EQ(hung.code(), StatusCode::kUnavailable);
  EXPECT_THAT(hung.message(), HasSubstr("too slow"));
  service_->signal(SIGCONT);
  EXPECT_TRUE(upload.abort().is_ok());
}

}  // namespace
}  // namespace burnish
