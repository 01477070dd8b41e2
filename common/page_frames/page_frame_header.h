#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/base/status.h"
#include "common/page_frames/page_kind.h"

namespace burnish {

// The frame format, version 2
//
// A frame carries the displacement of the surface to one client, for the pages that this client
// shows. The client says which pages, by changes that make one revision after the other
// (shown_pages.h); a frame names its revision. A tile is a shown page. Its values are
// three-vectors: one per vertex of the page or one per corner of the vertices' cells
// (PageFrameKind). Both ends know their number and order from the page and from the session's
// depth.
//
// The state of a frame is one integer per value and axis, in steps of 1/256 cell. A frame is
// complete: after it every shown page has
//
//     new = round(wanted) << step_shift               round(v) = (v + half) >> step_shift
//                                                     half = (1 << step_shift) >> 1
//
// So a value follows from the wanted one and from the frame's step alone. A vertex on the border of
// two pages has the same value in both, in every frame, and the surface has no cracks.
//
// A frame is coded as the difference to an earlier frame, its reference:
//
//     new = (round(old) + k) << step_shift            in pages that are sent
//     new = old                                       in the others
//
// old is zero in pages that the reference did not show, and everywhere if there is no reference (a
// key frame). All is integer arithmetic modulo 2^32 and the shift to the right keeps the sign, so
// both ends hold the same state bit for bit. After a frame of another step pages are sent whose
// values change, even if k is zero.
//
// Header, 56 bytes, little-endian:
//
//      0  char[4]  "BnFr"
//      4  u8       version, 2
//      5  u8       kind: 0 vertices, 1 corners
//      6  u8       step_shift, 0..7
//      7  u8       0
//      8  u64      sequence number, rising from 1
//     16  u64      sequence number of the reference, 0 in a key frame
//     24  u64      checksum of the reference, 0 in a key frame
//     32  u32      revision of the shown pages; never falls
//     36  f32      largest move of the whole surface, cells
//     40  u32      number of pages sent
//     44  u32      bytes of the body before compression
//     48  u64      checksum: XXH3 of the body, seeded with the XXH3 of the 48 bytes before
//
// A frame names its reference by number and checksum, so that a frame of another stream with the
// same number never passes for it.
//
// Body, one zstd frame. Uncompressed it is eight streams, one after the other. Pages are in the
// order of their numbers; a page has x, then y, then z; an axis has groups of 16 (the last is
// filled up with zeros):
//
//     flags    one byte per shown page: 1 if it is sent, +2 if its gain is, +4 if its held vertices
//              are
//     gains    one byte per page that says so: e
//     held     one bit per vertex of each page that says so, lowest first, filled up to bytes
//     widths   4 bits per group, low half first; a byte is not shared by two axes
//     packed   groups of 1, 2 and 4 bits a value, value 0 in the lowest bits
//     byte 0   groups of 8, 16 and 32 bits: the low byte of each value
//     byte 1   groups of 16 and 32 bits
//     byte 2   groups of 32 bits: byte 2 of a group's values, then byte 3
//
// A width w <= 6 means 0 bits for 0, else 2^(w-1) bits. The values are residuals of k against its
// prediction, in zigzag form (0, -1, 1, -2, ... become 0, 1, 2, 3, ...). The prediction is the mean
// of k of the n predictors, which are earlier values of the page (page_layout.h):
//
//     floor((2 * sum + n) / (2 * n))                  0 for the first value, which has none
//
// The sum is exact, each axis for itself. On scans the mean of all earlier neighbours took fewer
// bytes than parallelograms, which add up the rounding of three values (docs/lab/service.md).
//
// The gain of a page is 2^e, and no cell of the page has a larger beta. Like a value it lasts from
// the reference on; e is 0 in pages that the reference did not show. A client coarsens a page less
// where the gain is high: sharpening magnifies what simplification has removed.
//
// A held vertex is not displaced, whatever the values are. Held vertices last likewise; none is
// held in pages that the reference did not show. A server names them in frames of corners only, and
// only to a client whose greeting says that it knows them.

inline constexpr uint8_t kPageFrameFormatVersion = 2;
inline constexpr size_t kPageFrameHeaderBytes = 56;
inline constexpr int kPageStepShiftMax = 7;
inline constexpr int kPageGainExponentMax = 15;

struct PageFrameHeader {
  PageFrameKind kind = PageFrameKind::kVertices;
  uint8_t step_shift = 0;
  uint64_t sequence = 0;
  uint64_t reference = 0;
  uint64_t reference_checksum = 0;
  uint32_t revision = 0;
  float largest_move = 0;  ///< cells
  uint32_t sent_pages = 0;
  uint32_t body_bytes = 0;
  uint64_t checksum = 0;  ///< set by seal_page_frame()

  bool is_key() const { return reference == 0; }
};

/// Writes the header, with its checksum, into the first kPageFrameHeaderBytes of `frame`. Returns
/// the checksum.
uint64_t seal_page_frame(const PageFrameHeader& header, std::span<uint8_t> frame);

/// Reads the header and checks everything that does not need the shown pages. Fails: data_loss (too
/// short, not a frame, wrong checksum, a field outside its limits), unimplemented (another
/// version).
Result<PageFrameHeader> read_page_frame_header(std::span<const uint8_t> frame);

}  // namespace burnish
