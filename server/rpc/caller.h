#pragma once

#include <string>

#include <grpcpp/grpcpp.h>

#include "common/service/scan_info.h"

namespace burnish {

/// The header in which a client says who its user is.
inline constexpr char kUserHeader[] = "burnish-user-bin";

/// Who calls: the name that the client gives, or "". Fails: invalid_argument.
inline Result<std::string> caller_of(const grpc::CallbackServerContext& context) {
  const auto found = context.client_metadata().find(kUserHeader);
  if (found == context.client_metadata().end()) return std::string();
  std::string name(found->second.data(), found->second.size());
  RETURN_IF_ERROR(check_name("the user's name", name));
  return name;
}

}  // namespace burnish
