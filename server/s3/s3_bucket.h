#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/s3/s3_exchange.h"

namespace burnish {

/// A bucket of an S3 service. Requests are tried again a few times when the network or the service
/// fails. Messages name the bucket and the key, and nothing secret. Thread-safe.
class S3Bucket {
 public:
  S3Bucket(S3Address address, S3CredentialsSource credentials, S3Patience patience = {})
      : address_(std::move(address)), credentials_(std::move(credentials)), patience_(patience) {}

  /// Says whether this bucket can be listed and written to. Leaves nothing in it. Fails:
  /// failed_precondition (no such bucket, refused credentials), unavailable; as the credentials.
  Status check_access() const;

  /// Returns the bytes of an object. Fails: not_found; as the service says.
  Result<uint64_t> size_of(const std::string& name) const;

  /// Hands over an object in pieces. Goes on where a broken connection has ended. Fails: data_loss
  /// for more than `bytes_max`; not_found; cancelled; as `take`; as the service says.
  using Take = std::function<Status(std::string_view piece)>;
  Status get(const std::string& name, uint64_t bytes_max, const Take& take,
             const Progress& progress) const;

  /// Puts a short object there, in place of what there is.
  Status put(const std::string& name, std::string text) const;

  /// Removes all objects whose names begin with `name`, if there are any.
  Status remove_all(const std::string& name) const;

  /// Sends a request until it is answered, or cannot be. `make` makes it for each try. Fails:
  /// cancelled; as the request; as the service says.
  using MakeRequest = std::function<S3Request()>;
  Result<S3Reply> send(const MakeRequest& make, const Progress& progress = {}) const;
  /// Sends a request without a file, with a deadline for all tries.
  Result<S3Reply> send_quickly(S3Request request) const;

  const S3Address& address() const { return address_; }
  const S3Patience& patience() const { return patience_; }

 private:
  const S3Address address_;
  const S3CredentialsSource credentials_;
  const S3Patience patience_;
};

}  // namespace burnish
