#include "server/library/shared_bucket.h"

#include <spdlog/spdlog.h>

#include "server/library/checked_copy.h"
#include "server/library/scan_record.h"
#include "server/s3/s3_upload.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr char kBucket[] = "bucket";

std::string folder_of(const std::string& id) {
  return "scans/" + id + "/";
}

std::string original_of(const ScanInfo& scan) {
  return folder_of(scan.id) + original_file_name(scan.format);
}

}  // namespace

class SharedBucket::Staged final : public StagedOriginal {
 public:
  Staged(const S3Bucket& bucket, ScanInfo scan, S3Upload upload)
      : bucket_(bucket), scan_(std::move(scan)), upload_(std::move(upload)) {}

  Status send(const fs::path& original, const Progress& progress) {
    return upload_.send(original, scan_.id, progress);
  }
  Status place(bool replaces) override {
    return told_apart(put(replaces), kBucket, "sharing", scan_);
  }

 private:
  /// An answer may be lost: the second try to join the parts finds none, and a whole original.
  Status put(bool replaces) {
    if (!replaces && is_whole()) return Status::ok();
    RETURN_IF_ERROR(bucket_.put(folder_of(scan_.id) + "info.json", scan_to_json(scan_)));
    const Status joined = upload_.complete();
    if (joined.code() != StatusCode::kNotFound) return joined;
    return is_whole() ? Status::ok() : unavailable(joined.message());
  }

  bool is_whole() const {
    const auto size = bucket_.size_of(original_of(scan_));
    return size.is_ok() && *size == scan_.size_bytes;
  }

  const S3Bucket& bucket_;
  const ScanInfo scan_;
  S3Upload upload_;
};

Result<std::unique_ptr<SharedBucket>> SharedBucket::open(S3Address address,
                                                         S3CredentialsSource credentials,
                                                         S3Patience patience) {
  std::unique_ptr<SharedBucket> store(
      new SharedBucket(S3Bucket(std::move(address), std::move(credentials), patience)));
  RETURN_IF_ERROR(store->bucket_.check_access());
  return store;
}

Result<std::unique_ptr<StagedOriginal>> SharedBucket::copy_in(const fs::path& original,
                                                              const ScanInfo& scan,
                                                              const Progress& progress) {
  auto upload = S3Upload::begin(bucket_, original_of(scan));
  RETURN_IF_ERROR(told_apart(upload.status(), kBucket, "sharing", scan));
  auto staged = std::make_unique<Staged>(bucket_, scan, std::move(*upload));
  const Status sent = staged->send(original, progress);
  RETURN_IF_ERROR(told_apart(sent, kBucket, "sharing", scan));
  return std::unique_ptr<StagedOriginal>(std::move(staged));
}

Status SharedBucket::check(const ScanInfo& scan, const Progress& progress) const {
  const Progress checking = as_phase("checking", progress);
  const Status checked = check_pieces(original_of(scan), scan.id, [&](const TakePiece& take) {
    return bucket_.get(original_of(scan), scan.size_bytes, take, checking);
  });
  return told_apart(checked, kBucket, "checking", scan);
}

Status SharedBucket::fetch(const ScanInfo& scan, const fs::path& to,
                           const Progress& progress) const {
  const Status fetched = write_checked(original_of(scan), scan.id, to, [&](const TakePiece& take) {
    return bucket_.get(original_of(scan), scan.size_bytes, take, progress);
  });
  return told_apart(fetched, kBucket, "fetching", scan);
}

Status SharedBucket::remove(const std::string& id) {
  const Status removed = bucket_.remove_all(folder_of(id));
  if (removed.is_ok()) return removed;
  spdlog::error("{}: {}", kBucket, removed.message());
  return {removed.code(), "deleting the original in the bucket failed; see the log"};
}

}  // namespace burnish
