// What becomes of an original when a service loses answers. SharedLibraryTest has the rest, with a
// good one.

#include "server/library/shared_bucket.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/transfer/content_hash.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/s3/misbehaving_service.h"
#include "tests/server/s3/s3_service.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Has begun an upload, and says that it knows none when its parts are to be joined.
class LostAnswer : public testing::Test {
 protected:
  LostAnswer() {
    ContentHash hash;
    hash.update(kText);
    scan_.id = hash.finish();
    scan_.name = "ball";
    scan_.size_bytes = kText.size();
  }

  FakeAnswer answer(const MisbehavingService::Request& request) {
    if (request.line.starts_with("HEAD"))
      return {.status = is_there_ ? 200 : 404, .body_bytes = there_bytes_};
    if (request.line.starts_with("PUT")) return {.more_headers = "ETag: \"1\"\r\n"};
    if (request.line.find("uploads=") != std::string::npos)
      return {.body = "<UploadId>x</UploadId>"};
    if (!request.line.starts_with("POST")) return {};
    is_there_ = true;  // the first answer was lost, and this is the second one
    return {.status = 404, .body = "<Error><Code>NoSuchUpload</Code></Error>"};
  }

  Status place() {
    const MisbehavingService service([this](const auto& request) { return answer(request); });
    const auto store =
        SharedBucket::open(S3Address::parse({"s3://bucket", service.endpoint()}).value(),
                           S3Service::credentials, short_patience());
    RETURN_IF_ERROR(store.status());
    ASSIGN_OR_RETURN(const auto staged,
                     store.value()->copy_in(folder_.write("original", kText), scan_, {}));
    return staged->place(false);
  }

  static inline const std::string kText = "hello";
  const TemporaryFolder folder_;
  ScanInfo scan_;
  std::atomic<bool> is_there_ = false;
  std::atomic<size_t> there_bytes_ = kText.size();
};

TEST_F(LostAnswer, IsASuccessIfTheOriginalIsThere) {
  const Status placed = place();
  EXPECT_TRUE(placed.is_ok()) << placed.message();
}

TEST_F(LostAnswer, IsAFailureIfAnotherFileIsThere) {
  there_bytes_ = 3;
  const Status placed = place();
  EXPECT_EQ(placed.code(), StatusCode::kUnavailable);
  EXPECT_THAT(placed.message(), HasSubstr("sharing scan ball failed"));
}

}  // namespace
}  // namespace burnish
