#pragma once

#include <string>

#include "common/base/status.h"

namespace burnish {

/// A bucket as a configuration names it.
struct S3Settings {
  std::string uri;            ///< s3://BUCKET[/PREFIX]
  std::string endpoint = {};  ///< http[s]://HOST[:PORT]; empty: that of AWS in the region
  std::string region = "us-east-1";
  std::string addressing = "auto";  ///< path, virtual; auto: path for an endpoint, virtual for AWS
  std::string ca = {};              ///< file of the authorities to trust (PEM); empty: the system's
};

/// Makes letters that mean something in a query's value %XX, as they are signed.
std::string percent_encoded(const std::string& text);

bool is_s3_uri(const std::string& text);

/// A bucket, and the URLs of what is in it. No part of it is secret.
class S3Address {
 public:
  /// Fails: invalid_argument that names the setting. A value that may have a password in the wrong
  /// place is not repeated.
  static Result<S3Address> parse(const S3Settings& settings);

  /// Returns the key of `name` below the prefix.
  std::string key(const std::string& name) const { return prefix_ + name; }
  /// Returns the URL of a key; "" is the bucket itself.
  std::string url(const std::string& key) const;
  /// Returns "s3://BUCKET/KEY" for messages.
  std::string say(const std::string& key) const { return "s3://" + bucket_ + "/" + key; }

  const std::string& endpoint() const { return endpoint_; }
  const std::string& region() const { return region_; }
  const std::string& ca() const { return ca_; }

 private:
  std::string bucket_;
  std::string prefix_;  // "" or ends with '/'
  std::string endpoint_;
  std::string region_;
  std::string ca_;
  bool is_virtual_ = false;  // the bucket is a part of the host's name
};

}  // namespace burnish
