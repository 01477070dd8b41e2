#pragma once

#include "client/web/core/messages/message.h"

namespace burnish::messages {

/// How a value lies in the bytes, by protobuf's encoding. Groups, 3 and 4, are not here.
enum class WireType : uint8_t { kVarint = 0, kEightBytes = 1, kBytes = 2, kFourBytes = 5 };

constexpr WireType wire_type(Kind kind) {
  switch (kind) {
    case Kind::kDouble:
      return WireType::kEightBytes;
    case Kind::kFixed32:
    case Kind::kFloat:
      return WireType::kFourBytes;
    case Kind::kString:
    case Kind::kBytes:
    case Kind::kMessage:
      return WireType::kBytes;
    default:
      return WireType::kVarint;
  }
}

}  // namespace burnish::messages
