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

inline constexpr uint8_t kSheetFormatVersion = 1;
inline constexpr size_t kChartHeaderBytes = 24;

inline constexpr std::array<char, 4> kChartMagic = {'B', 'n', 'S', 'c'};

}  // namespace burnish
