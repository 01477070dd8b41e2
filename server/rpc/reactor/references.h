#pragma once

#include "common/base/status.h"
#include "common/base/text.h"

namespace burnish {

/// Returns false if the request may name a session and does not.
template <typename Request>
bool has_session(const Request& request) {
  if constexpr (requires { request.has_session(); })
    return request.has_session();
  else
    return true;
}

/// Checks the names in a request: its session and its scan. A new session may have no name; its
/// name is checked elsewhere. Fails: invalid_argument that names the field and its limit.
template <typename Request>
Status check_references(const Request& request) {
  if constexpr (requires { check_name("", request.session()); })
    if (has_session(request))
      RETURN_IF_ERROR(check_name("the session's name or id", request.session()));
  if constexpr (requires { check_name("", request.scan()); })
    RETURN_IF_ERROR(check_name("the scan's name or id", request.scan()));
  if constexpr (requires { request.greeting().session(); })
    RETURN_IF_ERROR(check_references(request.greeting()));
  return Status::ok();
}

}  // namespace burnish
