#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "common/frame_codec/frame_layout.h"

namespace burnish {

/// The layout of the fuzzer's streams: a plane of cells, two tiles, the second not full.
std::shared_ptr<const FrameLayout> frame_stream_layout();

/// Decodes the fuzzer's input: a stream of frames for one decoder. Each frame begins with a byte
/// for its kind and two bytes of length, low first:
///   0  a frame, unchanged;
///   1  a frame whose header is sealed again, so that its checksum is right;
///   2  a frame whose body is compressed first, then sealed.
/// No stream may crash the decoder, and a refused frame must not change it.
/// Returns how many frames were decoded.
int decode_frame_stream(std::span<const uint8_t> stream);

}  // namespace burnish
