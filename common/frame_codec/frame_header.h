#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/frame_codec/frame_content.h"

namespace burnish {

// The frame format, version 1
//
// A frame carries a displacement from the server to one client. Its values are three-vectors: one
// per corner that weighs on a vertex, or one per vertex (FrameContent). Both ends compute the
// values and their order from the evaluation points (FrameLayout); the layout's fingerprint in each
// frame checks that they agree. 2048 values in Morton order make a tile.
//
// The state of a frame is one integer per value and axis, in units of 1/256 cell. A frame says how
// the state of an earlier frame, its reference, becomes its state:
//
//     new = old + (k << step_shift)          k = 0 throughout a tile that is not sent
//
// A key frame has no reference; old is zero. step_shift is 2 while the surface moves, up to 6 on a
// slow link, and 0 when the surface is still. Everything is integer arithmetic modulo 2^32, so both
// ends hold the same state bit for bit, and errors do not add up: k is chosen against the state
// that the client holds.
//
// Header, 64 bytes, little-endian:
//
//      0  char[4]  "BnFr"
//      4  u8       version, 1
//      5  u8       content: 0 coefficients, 1 vertices
//      6  u8       step_shift, 0..7
//      7  u8       0
//      8  u64      sequence number, rising from 1
//     16  u64      sequence number of the reference, 0 in a key frame
//     24  u64      checksum of the reference, 0 in a key frame
//     32  u64      fingerprint of the layout
//     40  u32      number of tiles sent
//     44  u32      bytes of the body before compression
//     48  u64      0
//     56  u64      checksum: XXH3 of the body, seeded with the XXH3 of the 56 bytes before
//
// A frame names its reference by number and checksum, so that a frame of another stream with the
// same number never passes for it.
//
// Body, one zstd frame. Uncompressed it is six streams, one after the other. Tiles are in order; a
// tile has x, then y, then z; an axis has groups of 16 (the last is filled up with zeros):
//
//     tiles    one byte per tile of the layout: 1 sent, 0 not
//     widths   4 bits per group, low half first; a byte is not shared by two axes
//     packed   groups of 1, 2 and 4 bits a value, value 0 in the lowest bits
//     byte 0   groups of 8, 16 and 32 bits: the low byte of each value
//     byte 1   groups of 16 and 32 bits
//     byte 2   groups of 32 bits: byte 2 of a group's values, then byte 3
//
// A width w <= 6 means 0 bits for 0, else 2^(w-1) bits. The values are residuals of k against its
// prediction from earlier values of the same tile and axis, k[a] + k[b] - k[c], in zigzag form (0,
// -1, 1, -2, ... become 0, 1, 2, 3, ...). The layout gives a, b, c of each value: for coefficients
// the neighbours in the grid, for vertices the value before.
//
// docs/protocol.md describes the format, the layout and its fingerprint for clients in other
// languages.
//
// tests/bench/codec_bench compares this with zstd alone, byte planes, and meshoptimizer's vertex
// codec with zstd. On coefficients meshoptimizer took 1.3 to 3.5 times the bytes, except for one
// still frame.

inline constexpr uint8_t kFrameFormatVersion = 1;
inline constexpr size_t kFrameHeaderBytes = 64;
inline constexpr uint8_t kStepShiftMax = 7;

/// How finely a frame rounds.
enum class FrameStep : uint8_t {
  kStill = 0,     ///< 1/256 cell: exactly the rounded displacement
  kMoving = 2,    ///< 1/64 cell
  kCoarsest = 6,  ///< 1/4 cell: the surface moves and the link is slow
};

struct FrameHeader {
  FrameContent content = FrameContent::kCoefficients;
  uint8_t step_shift = 0;
  uint64_t sequence = 0;
  uint64_t reference = 0;
  uint64_t reference_checksum = 0;
  uint64_t layout_fingerprint = 0;
  uint32_t sent_tiles = 0;
  uint32_t body_bytes = 0;
  uint64_t checksum = 0;  ///< set by seal_frame()

  bool is_key() const { return reference == 0; }
};

/// Writes the header, with its checksum, into the first kFrameHeaderBytes of `frame`. Returns the
/// checksum.
uint64_t seal_frame(const FrameHeader& header, std::span<uint8_t> frame);

/// Reads the header and checks everything that does not need a layout. Fails: data_loss (too short,
/// not a frame, wrong checksum, a field outside its limits), unimplemented (another version).
Result<FrameHeader> read_frame_header(std::span<const uint8_t> frame);

}  // namespace burnish
