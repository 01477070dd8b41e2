#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/s3/s3_bucket.h"

namespace burnish {

/// A file on its way into a bucket, in parts that nobody sees. All of it appears at once, or it
/// goes with this object. If the process dies before that, its parts stay until the bucket's
/// lifecycle rule removes them.
class S3Upload {
 public:
  /// Needs: `bucket` outlives the upload. Fails: as the service says.
  static Result<S3Upload> begin(const S3Bucket& bucket, const std::string& name);
  S3Upload(S3Upload&& other) noexcept;
  S3Upload& operator=(S3Upload&&) = delete;
  ~S3Upload();

  /// Sends a file. Fails: data_loss if it does not have this SHA-256; cancelled; unavailable if
  /// the service has forgotten the upload; as errno says; as the service says.
  Status send(const std::filesystem::path& path, const std::string& sha256,
              const Progress& progress);

  /// Makes the object appear, in place of what there is. Fails: not_found if the service does not
  /// know the upload, which it may have completed before; as the service says.
  Status complete();

  /// Makes the service forget the parts.
  Status abort();

 private:
  S3Upload(const S3Bucket& bucket, std::string key, std::string id)
      : bucket_(&bucket), key_(std::move(key)), id_(std::move(id)) {}

  const S3Bucket* bucket_;
  std::string key_;
  std::string id_;  // "": over
  std::vector<std::string> etags_;
};

}  // namespace burnish
