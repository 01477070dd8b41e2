#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace burnish {

// The page format, version 1
//
// A scan's surface lies in pages of several levels of detail. Level 0 is the scan, cut into pages.
// Each page of level k alone is simplified with its border kept; the triangles that this makes are
// cut anew into the pages of level k+1. The last level is one page, the root. So a page p of level
// k+1 has triangles that replace several pages c of level k: they are its patches (p -> c).
//
// Take any set of pages that holds, with each page, all pages that have a patch for it. Draw a
// patch (p -> c) if p is in the set and c is not. That is the whole surface, once and without
// cracks: borders of pages are the same lattice points in all pages that meet there.
//
// Pages are numbered from fine to coarse. All is little-endian.
//
// The file
//
//     pages        level 0 first
//     blocks       of the directory, one per up to 256 pages of one level
//     head         the lattice, the levels, one entry per block
//     tail         u32 bytes of the head, char[4] "BnPt"
//
// A client reads the head, then the blocks of the regions that it shows, then pages. Head, block
// and page each have a checksum: XXH3 of what follows their header, seeded with the XXH3 of the
// header before the checksum.
//
// Head: a header of 80 bytes, then u32 pages of each level, then 40 bytes per block.
//
//      0  char[4]  "BnPh"
//      4  u8       version, 1
//      5  u8       Q, bits of the lattice: 1..24
//      6  u8       levels, 1..64
//      7  u8       1 if pages have colours, else 0
//      8  f64[3]   the cube's least corner, file units
//     32  f64      side of the cube, file units
//     40  u64      vertices of the scan
//     48  u64      triangles of the scan
//     56  u64      bytes of all pages
//     64  u64      bytes of all blocks
//     72  u64      checksum
//
//     block: f32[3] centre, f32 radius, f32 error, f32 edge, u32 bytes of the block, u32 0,
//            u64 offset in the file of its first page; its pages follow each other
//
// A lattice point q means origin + (q + 1/2) * side / 2^Q. Centres are relative to the origin.
//
// Block: a header of 32 bytes, then one zstd frame.
//
//      0  char[4]  "BnPd"
//      4  u8       version, 1
//      5  u8[3]    0
//      8  u32      number of its first page
//     12  u32      pages
//     16  u32      coarser pages, of all its pages together
//     20  u32      0
//     24  u64      checksum
//
//     The frame holds u32 words, packed as byte planes of zigzag differences to the word before
//     (common/packing/word_section.h). They are columns, a word per page each: f32 centre x, y, z,
//     radius, error, edge; bytes of the page; vertices + 65536 * triangles; number of coarser
//     pages. Then the coarser pages of all pages, rising for each page.
//
// Page: a header of 48 bytes, then one zstd frame.
//
//      0  char[4]  "BnPg"
//      4  u8       version, 1
//      5  u8       1: normals of all vertices, else of border vertices; +2: colours
//      6  u8       bytes of a position's coordinate, 0..4
//      7  u8       0
//      8  u32      number of the page
//     12  u16      vertices
//     14  u16      triangles
//     16  u16      border vertices
//     18  u16      patches
//     20  u16      steps of the walk
//     22  u16      named vertices
//     24  u16      named patches
//     26  u16      0
//     28  u32[3]   position of the first vertex
//     40  u64      checksum
//
//     The frame holds these sections, one behind the other. A plane has one byte of each number.
//
//     section   numbers                                            stored as
//     finer     patches' finer pages, difference to the one before  4 planes
//     steps     one per step of the walk                            4 bits, low half first
//     vertices  named by the walk                                   2 planes
//     turns     one per triangle, if there is more than one patch   1 bit, low bit first
//     patches   named by turns                                      2 planes
//     border    one per vertex, 1 if it is on the border            1 bit, low bit first
//     places    x of all vertices, then y, then z; zigzag           planes as the header says
//     normals   u of those that have one, then v; zigzag             1 plane
//     colours   green, red - green, blue - green, alpha             1 plane each
//
//     The walk (page_walk.h) gives triangles and vertices in its order. Vertices are then sorted
//     into those on the border and the others; triangles are sorted by patch.
//
//     Places, normals and colours are differences to a prediction. Places: a + b - c of the walk;
//     the first vertex is in the header. Normals: octahedral codes modulo 256, predicted from the
//     page's triangles in integers (octahedral.h). Colours: half the sum of those at a and b,
//     rounded down, modulo 256; the first is predicted as 0.
//
// docs/protocol.md describes the format for clients in other languages.

inline constexpr uint8_t kPageFormatVersion = 1;
inline constexpr size_t kPageHeaderBytes = 48;
inline constexpr size_t kPageBlockHeaderBytes = 32;
inline constexpr size_t kPageHeadHeaderBytes = 80;

inline constexpr std::array<char, 4> kPageMagic = {'B', 'n', 'P', 'g'};
inline constexpr std::array<char, 4> kPageBlockMagic = {'B', 'n', 'P', 'd'};
inline constexpr std::array<char, 4> kPageHeadMagic = {'B', 'n', 'P', 'h'};
inline constexpr std::array<char, 4> kPageTailMagic = {'B', 'n', 'P', 't'};

struct PageTail {
  uint32_t head_bytes = 0;
  std::array<char, 4> magic = kPageTailMagic;
};
static_assert(sizeof(PageTail) == 8);

}  // namespace burnish
