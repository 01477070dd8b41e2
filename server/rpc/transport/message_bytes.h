#pragma once

#include <grpcpp/grpcpp.h>

#include "common/base/check.h"
#include "common/base/status.h"
#include "server/metrics/metrics.h"

namespace burnish {

// Calls that read a stream take bytes and parse them here: after a malformed message gRPC's
// reactors only hear of the stream's end. Such calls also write bytes.

/// Counts the refusal of a message that is malformed, or in the wrong place of its stream.
inline Status malformed(Status refusal) {
  metrics().count_refusal(Refusal::kMalformed);
  return refusal;
}

/// Empties `bytes`. Fails: invalid_argument, counted, if they are not such a message.
template <typename Message>
Status parse(grpc::ByteBuffer& bytes, Message& message) {
  if (grpc::SerializationTraits<Message>::Deserialize(&bytes, &message).ok()) return Status::ok();
  return malformed(invalid_argument("the message is not a valid " + Message::descriptor()->name()));
}

template <typename Message>
void serialize(const Message& message, grpc::ByteBuffer& bytes) {
  bytes.Clear();  // gRPC needs it empty
  bool is_ours = false;
  const auto status = grpc::SerializationTraits<Message>::Serialize(message, &bytes, &is_ours);
  BURNISH_CHECK(status.ok(), "a message of ours has bytes");
}

}  // namespace burnish
