#include <cstddef>
#include <cstdint>

#include "tests/common/frame_codec/frame_stream.h"

/// Any stream of frames must be decoded or refused, and a refused frame must change nothing.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  burnish::decode_frame_stream({data, size});
  return 0;
}
