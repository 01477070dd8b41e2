#include "server/s3/s3_upload.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include "common/transfer/content_hash.h"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kPartsMax = 10'000;
constexpr size_t kPieceBytes = 1 << 20;

/// A file that is read at any place.
class ReadFile {
 public:
  explicit ReadFile(const fs::path& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;
  ~ReadFile() {
    if (file_ >= 0) ::close(file_);
  }

  bool is_open() const { return file_ >= 0; }
  uint64_t size() const {
    struct stat found = {};
    return ::fstat(file_, &found) == 0 ? static_cast<uint64_t>(found.st_size) : 0;
  }
  /// Returns 0 at the end, and if the bytes cannot be read.
  size_t read(uint64_t offset, char* to, size_t bytes_max) const {
    for (;;) {
      const ssize_t bytes = ::pread(file_, to, bytes_max, static_cast<off_t>(offset));
      if (bytes >= 0) return static_cast<size_t>(bytes);
      if (errno != EINTR) return 0;
    }
  }

 private:
  int file_;
};

/// Returns the SHA-256 of a part, and adds its bytes to the hash of the whole.
std::string hash_part(const ReadFile& file, uint64_t begin, uint64_t bytes, ContentHash& whole) {
  ContentHash part;
  std::string piece(kPieceBytes, '\0');
  for (uint64_t done = 0; done < bytes;) {
    const size_t wanted = std::min<uint64_t>(piece.size(), bytes - done);
    const size_t read = file.read(begin + done, piece.data(), wanted);
    if (read == 0) break;  // sending it will fail
    part.update({piece.data(), read});
    whole.update({piece.data(), read});
    done += read;
  }
  return part.finish();
}

}  // namespace

Result<S3Upload> S3Upload::begin(const S3Bucket& bucket, const std::string& name) {
  S3Request request{"POST", bucket.address().key(name)};
  request.query = "uploads=";
  const std::string key = request.key;
  ASSIGN_OR_RETURN(const S3Reply reply, bucket.send_quickly(std::move(request)));
  const std::string id = xml_text(reply.body, "UploadId");
  if (id.empty())
    return internal_error("POST " + bucket.address().say(key) + ": the answer has no UploadId");
  return S3Upload(bucket, key, percent_encoded(id));
}

S3Upload::S3Upload(S3Upload&& other) noexcept
    : bucket_(other.bucket_),
      key_(std::move(other.key_)),
      id_(std::exchange(other.id_, {})),
      etags_(std::move(other.etags_)) {}

S3Upload::~S3Upload() {
  const Status status = abort();
  if (!status.is_ok()) spdlog::warn("parts of an upload are left: {}", status.message());
}

Status S3Upload::abort() {
  if (id_.empty()) return Status::ok();
  S3Request request{"DELETE", key_};
  request.query = "uploadId=" + std::exchange(id_, {});
  const Status status = bucket_->send_quickly(std::move(request)).status();
  return status.code() == StatusCode::kNotFound ? Status::ok() : status;
}

Status S3Upload::send(const fs::path& path, const std::string& sha256, const Progress& progress) {
  const ReadFile file(path);
  if (!file.is_open()) return errno_status("cannot read " + path.string(), errno);
  const uint64_t size = file.size();
  const uint64_t part_bytes =
      std::max(bucket_->patience().part_bytes, (size + kPartsMax - 1) / kPartsMax);
  ContentHash whole;
  for (uint64_t begin = 0; begin == 0 || begin < size; begin += part_bytes) {
    const uint64_t bytes = std::min(part_bytes, size - begin);
    S3Request request{"PUT", key_};
    request.query = "partNumber=" + std::to_string(etags_.size() + 1) + "&uploadId=" + id_;
    request.body = {bytes, hash_part(file, begin, bytes, whole),
                    [&](uint64_t offset, char* to, size_t bytes_max) {
                      return file.read(begin + offset, to, bytes_max);
                    }};
    request.on_bytes = [&](uint64_t done) {
      const double part = static_cast<double>(begin + std::min(done, bytes));
      return report(progress, "sharing", size == 0 ? 0 : part / static_cast<double>(size));
    };
    const auto reply = bucket_->send([&] { return request; }, progress);
    if (reply.status().code() == StatusCode::kNotFound)  // somebody has ended the upload
      return unavailable(reply.status().message());
    RETURN_IF_ERROR(reply.status());
    if (reply->etag.empty() || reply->etag.find_first_of("<&") != std::string::npos)
      return internal_error("PUT " + bucket_->address().say(key_) + ": the answer has no ETag");
    etags_.push_back(reply->etag);
  }
  const std::string found = whole.finish();
  if (found == sha256) return Status::ok();
  return data_loss(path.string() + " has SHA-256 " + found + ", not " + sha256);
}

Status S3Upload::complete() {
  std::string text = "<CompleteMultipartUpload>";
  for (size_t part = 0; part < etags_.size(); ++part)
    text += "<Part><PartNumber>" + std::to_string(part + 1) + "</PartNumber><ETag>" + etags_[part] +
            "</ETag></Part>";
  S3Request request{"POST", key_};
  request.query = "uploadId=" + id_;
  request.body = text_body(text + "</CompleteMultipartUpload>");
  RETURN_IF_ERROR(bucket_->send_quickly(std::move(request)).status());
  id_.clear();
  return Status::ok();
}

}  // namespace burnish
