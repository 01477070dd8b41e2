#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace burnish {

// The sheet format, version 1
//
// A scan's texture lies in sheets beside its pages (common/pages/page_format.h): small pictures of
// one page each. A page is cut into charts, planar projections of its triangles. So a texel's place
// is an affine function of the position, and pages carry no texture coordinates:
//
//     x = (p·u - u0) * d + chart x + gutter + 1/2
//     y = (p·v - v0) * d + chart y + gutter + 1/2
//
// p is the original position in steps of PageGrid, (u0, v0) the chart's corner in steps, d the
// density in texels per step. A texel's centre lies at its number + 1/2. A page has 1..8 sheets,
// each of half the density of the one before, over the same charts.
//
// All is little-endian. Each part has a checksum as in page_format.h: XXH3 of what follows its
// header, seeded with the XXH3 of the header before the checksum.
//
// Charts of a page: a header of 24 bytes, then one zstd frame.
//
//      0  char[4]  "BnSc"
//      4  u8       version, 1
//      5  u8[3]    0
//      8  u32      number of the page
//     12  u16      charts, 1..triangles
//     14  u16      turns that name a chart
//     16  u64      checksum
//
//     The frame holds these sections, one behind the other. A plane has one byte of each number.
//
//     section   numbers                                             stored as
//     turns     one per triangle, in the order of the decoded page   1 bit, low bit first
//     named     charts that turns of 1 name                          2 planes
//     normals   octahedral u of all charts, then v; limit 32767      2 planes each
//     angles    of u around the normal, 2^16 a turn                  2 planes
//     corners   u0 of all charts, then v0; steps                     4 planes each
//
//     A turn of 1 names the chart of its triangle; one of 0 stands for that of the triangle before.
//     Charts are numbered by their first triangles. A named chart differs from the one before.

// Sheet: a header of 32 bytes, one zstd frame, then one WebP file.
//
//      0  char[4]  "BnSt"
//      4  u8       version, 1
//      5  u8       codec: 1 WebP lossy, 2 WebP lossless
//      6  u16      charts
//      8  u32      number of the page
//     12  u8       halving: 0 is the finest sheet of the page, 0..7
//     13  u8[3]    0
//     16  u16      width, texels with all gutters, 9..1024
//     18  u16      height
//     20  f32      density, texels per file unit: 0 < density < 2^40
//     24  u64      checksum
//
//     The frame holds x of all charts, then y: texels, 2 planes each. A chart takes
//     ceil(extent * d) + 9 texels a side: the extent is that of its triangles from (u0, v0) on. The
//     WebP has the header's size and one frame. It has an alpha plane only where a texel has an
//     alpha below 255; sheets are drawn opaque.
//
// The file
//
//     sheets       of page 0, the finest first, then of page 1 ...
//     charts       of page 0, then of page 1 ...
//     blocks       one per block of the page file, of the same pages
//     head         what it belongs to, one entry per block
//     tail         u32 bytes of the head, char[4] "BnSe"
//
// Head: a header of 64 bytes, then 24 bytes per block.
//
//      0  char[4]  "BnSh"
//      4  u8       version, 1
//      5  u8       gutter, 4 texels
//      6  u16      0
//      8  u64      fingerprint of the pages
//     16  u64      fingerprint of the pictures
//     24  u32      blocks
//     28  u32      0
//     32  u64      bytes of all sheets
//     40  u64      bytes of all charts
//     48  u64      bytes of all blocks
//     56  u64      checksum
//
//     block: u64 offset in the file of its first sheet, u64 offset of its first charts, u32 bytes
//            of the block, u32 0
//
// Block: a header of 32 bytes, then one zstd frame.
//
//      0  char[4]  "BnSb"
//      4  u8       version, 1
//      5  u8[3]    0
//      8  u32      number of its first page
//     12  u32      pages, 1..256
//     16  u32      sheets of all its pages together
//     20  u32      0
//     24  u64      checksum
//
//     The frame holds u32 words, packed as byte planes of zigzag differences to the word before
//     (common/packing/word_section.h). They are columns, a word per page each: bytes of the charts;
//     sheets, 1..8; f32 density of the finest sheet. Then columns with a word per sheet: bytes;
//     width + 65536 * height.

inline constexpr uint8_t kSheetFormatVersion = 1;
inline constexpr size_t kChartHeaderBytes = 24;

inline constexpr size_t kSheetHeaderBytes = 32;
inline constexpr size_t kSheetBlockHeaderBytes = 32;
inline constexpr size_t kSheetHeadHeaderBytes = 64;

inline constexpr std::array<char, 4> kChartMagic = {'B', 'n', 'S', 'c'};
inline constexpr std::array<char, 4> kSheetMagic = {'B', 'n', 'S', 't'};
inline constexpr std::array<char, 4> kSheetBlockMagic = {'B', 'n', 'S', 'b'};
inline constexpr std::array<char, 4> kSheetHeadMagic = {'B', 'n', 'S', 'h'};
inline constexpr std::array<char, 4> kSheetTailMagic = {'B', 'n', 'S', 'e'};

struct SheetTail {
  uint32_t head_bytes = 0;
  std::array<char, 4> magic = kSheetTailMagic;
};
static_assert(sizeof(SheetTail) == 8);

}  // namespace burnish
