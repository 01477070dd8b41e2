#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "server/library/original_store.h"
#include "server/s3/s3_bucket.h"

namespace burnish {

/// A bucket of originals. A scan is uploaded in parts, and appears when they are joined. The layout
/// is that of SharedFolder, so that one can be copied into the other.
///
///     PREFIX/scans/ID/    original.EXT, and info.json as it was at the import
class SharedBucket final : public OriginalStore {
 public:
  /// Tries whether the bucket can be listed and written to. Fails: as S3Bucket::check_access().
  static Result<std::unique_ptr<SharedBucket>> open(S3Address address,
                                                    S3CredentialsSource credentials,
                                                    S3Patience patience = {});

  Result<std::unique_ptr<StagedOriginal>> copy_in(const std::filesystem::path& original,
                                                  const ScanInfo& scan,
                                                  const Progress& progress) override;
  Status check(const ScanInfo& scan, const Progress& progress) const override;
  Status fetch(const ScanInfo& scan, const std::filesystem::path& to,
               const Progress& progress) const override;
  Status remove(const std::string& id) override;

 private:
  class Staged;
  explicit SharedBucket(S3Bucket bucket) : bucket_(std::move(bucket)) {}

  const S3Bucket bucket_;
};

}  // namespace burnish
