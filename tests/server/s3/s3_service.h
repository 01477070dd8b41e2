#pragma once

#include <memory>
#include <string>

#include "server/s3/s3_bucket.h"
#include "tests/common/temporary_folder.h"
#include "tests/system/process.h"

namespace burnish {

/// An S3 service of a test's own on a loopback port, with one bucket. It checks signatures and
/// hashes of bodies.
class S3Service {
 public:
  /// Returns whether its programs are there; deploy/setup installs them.
  static bool is_installed();
  static constexpr char kMissing[] = "Swift is missing: deploy/setup installs python3-swift";

  /// With a certificate and its key it serves https.
  explicit S3Service(std::string certificate = {}, std::string key = {});

  /// Starts it again on the same port, with its bucket and without objects.
  void start();
  /// Sends SIGKILL, and waits for its end.
  void kill() { process_.reset(); }
  /// Stops or continues it.
  void signal(int number) const { process_->signal(number); }

  std::string endpoint() const { return (certificate_.empty() ? "http" : "https") + rest_; }
  /// Returns the settings of the bucket, with a prefix.
  S3Settings settings() const { return {"s3://bucket/lab", endpoint()}; }
  S3Address address() const { return S3Address::parse(settings()).value(); }
  S3Bucket bucket(const S3Patience& patience) const;

  static Result<S3Credentials> credentials() { return S3Credentials{kId, kSecret, ""}; }
  static constexpr char kId[] = "lab:burnish";
  static constexpr char kSecret[] = "a-secret-of-tests";

 private:
  const TemporaryFolder folder_;
  const std::string certificate_, key_;
  std::string port_ = "0";
  std::string rest_;
  std::unique_ptr<Process> process_;
  int starts_ = 0;
};

/// A service that fails is given up soon. Where a request waits, the service has the clock.
S3Patience short_patience();

}  // namespace burnish
