#pragma once

#include <grpcpp/grpcpp.h>

#include "burnish/v1/editing.pb.h"
#include "common/base/server_place.h"
#include "common/base/status.h"
#include "common/base/text.h"
#include "common/wire/status_wire.h"
#include "server/process/hidden_folder.h"

namespace burnish {

/// A status is a header. Many clients refuse more than 8 kB of headers.
inline constexpr size_t kStatusBytesMax = 1000;

inline std::string details_of(const Status& status) {
  if (status.moved_to().empty()) return {};
  const ServerPlace place = ServerPlace::of(status.moved_to());
  v1::Moved moved;
  moved.set_address(place.address);
  moved.set_node(place.node);
  return moved.SerializeAsString();
}

inline grpc::Status to_grpc(const Status& status) {
  if (status.is_ok()) return grpc::Status::OK;
  return {static_cast<grpc::StatusCode>(status_code_to_wire(status.code())),
          shortened(text_for_client(status.message()), kStatusBytesMax), details_of(status)};
}

}  // namespace burnish
