#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/status.h"
#include "server/s3/s3_address.h"
#include "server/s3/s3_credentials.h"
#include "server/s3/s3_reply.h"

namespace burnish {

/// How long the service may take.
struct S3Patience {
  std::chrono::milliseconds connect{5'000};
  std::chrono::seconds silence{20};         ///< with less than 1 KiB/s
  std::chrono::milliseconds quick{15'000};  ///< for all tries of a request without a file
  int tries = 4;
  std::chrono::milliseconds pause{250};      ///< before the second try; twice that before the next
  uint64_t part_bytes = uint64_t{64} << 20;  ///< of an upload; at most 10,000 parts make a file
};

/// The source of a request's body.
struct S3Body {
  uint64_t bytes = 0;
  std::string sha256;  ///< of all of them
  /// Puts bytes from `offset` on to `to`, and returns their number; 0: they cannot be read.
  std::function<size_t(uint64_t offset, char* to, size_t bytes_max)> read = {};
};

S3Body no_body();
S3Body text_body(std::string text);

struct S3Request {
  const char* method;
  std::string key;         ///< "": the bucket itself
  std::string query = {};  ///< as it is signed: sorted NAME=VALUE, percent-encoded
  S3Body body = no_body();
  /// Gets the body of a good answer, from `first_byte` on. Its failure ends the request.
  std::function<Status(std::string_view)> take = {};
  uint64_t first_byte = 0;
  /// Hears of sent and received bytes, and at least once a second. Returns false to cancel.
  std::function<bool(uint64_t bytes)> on_bytes = {};
  std::optional<std::chrono::milliseconds> time_max = {};  ///< for all of it
};

/// Signs a request, sends it, and waits for its answer. Fails: cancelled; as `take`. All else is in
/// the reply.
Result<S3Reply> exchange(const S3Address& address, const S3Credentials& credentials,
                         const S3Request& request, const S3Patience& patience);

}  // namespace burnish
