#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The answer of a service, or why there is none.
struct S3Reply {
  int http = 0;              ///< status of HTTP; 0: no whole answer came
  std::string trouble = {};  ///< of the network
  std::string code = {};     ///< S3's word for a failure, e.g. NoSuchKey
  std::string etag = {};     ///< as it came, with its quotes
  std::string region = {};   ///< where the bucket is, if the service says so
  uint64_t bytes = 0;        ///< Content-Length
  std::string body = {};     ///< the beginning of what nobody took
};

/// Returns the texts of all elements of this name.
std::vector<std::string> xml_texts(const std::string& xml, const std::string& element);
/// Returns the first one; "" if there is none.
std::string xml_text(const std::string& xml, const std::string& element);

/// Takes S3's word for a failure from the body. An answer 200 may have one too: a service that
/// joins parts for long has begun to answer before it fails.
void read_code(S3Reply& reply);

bool is_good(const S3Reply& reply);

/// Returns whether another try may succeed: the network failed, or the service says so.
bool may_succeed_later(const S3Reply& reply);

/// Returns the failure of a request as a Status that begins with `what`: not_found for a missing
/// key; failed_precondition for a missing bucket and for refused credentials; unavailable;
/// resource_exhausted; internal.
Status status_of(const S3Reply& reply, const std::string& what);

}  // namespace burnish
