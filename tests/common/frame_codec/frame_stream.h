#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "common/frame_codec/frame_layout.h"

namespace burnish {

/// The layout of the fuzzer's streams: a plane of cells, two tiles, the second not full.
std::shared_ptr<const FrameLayout> frame_stream_layout();

/// What the fuzzer feeds: a stream of frames for one decoder. Each begins with a byte that says
/// what its bytes are, and two bytes of length, low first:
///   0  a frame as it is;
///   1  a frame whose header is to be sealed anew, so that its checksum is right;
///   2  a frame whose body is not compressed yet, to be compressed and sealed.
/// Every stream must be survived, and every refused frame must leave the decoder as it was.
/// Returns how many frames were decoded.
int decode_frame_stream(std::span<const uint8_t> stream);

}  // namespace burnish
