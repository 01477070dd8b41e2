#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/grid/grid.h"
#include "common/grid/morton.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

// The view format, version 1
//
// A view is a header and six sections. It has no positions of vertices: they follow from the
// evaluation points to 2^-25 of a cell, finer than any picture and than the floats of a graphics
// card. Only vertices in no cell have their own position. Corners of the grid follow from its
// cells.
//
// Header, 168 bytes, little-endian:
//
//      0  char[4]  "BnVw"
//      4  u8       version, 1
//      5  u8       depth, 4..12
//      6  u16      0
//      8  f64[3]   the grid's origin, file units
//     32  f64      edge of a cell, file units
//     40  f64      L = sqrt(area of the scan), file units
//     48  u64      vertices of the whole scan
//     56  u64      triangles of the whole scan
//     64  u64[6]   elements of each section
//    112  u64[6]   bytes of each section as it lies in the file
//    160  u64      checksum: XXH3 of the sections, seeded with the XXH3 of the 160 bytes before
//
// Sections, one after the other, each one zstd frame:
//
//    section    an element is             words      difference to
//    cells      Morton key                u64        the one before
//    triangles  three vertices            3 × u32    the same corner of the triangle before
//    homes      a vertex's cell, or -1    u32        the one before
//    locals     x, y, z in the cell       3 × f32    none
//    strays     position of a -1 vertex   3 × f64    none
//    colours    red, green, blue, alpha   u32        none
//
// Differences are taken modulo 2^bits and zigzag coded (0, -1, 1, -2, ... become 0, 1, 2, 3, ...);
// the first counts from zero. A section's words are stored as byte planes: the lowest byte of all
// words, then the next byte, and so on. So bytes that hardly change lie together, which helps zstd.
//
// docs/protocol.md describes the format for clients in other languages.

inline constexpr uint8_t kViewFormatVersion = 1;
inline constexpr size_t kViewHeaderBytes = 168;

enum class ViewSection { kCells, kTriangles, kHomes, kLocals, kStrays, kColours };
inline constexpr size_t kViewSections = 6;

/// The unpacked header and sections. Nothing is checked.
struct ViewParts {
  GridFrame frame;
  double length_unit = 1;
  uint64_t scan_vertices = 0;
  uint64_t scan_triangles = 0;
  std::vector<MortonKey> cells;
  std::vector<Triangle> triangles;
  std::vector<int32_t> homes;
  std::vector<std::array<float, 3>> locals;
  std::vector<std::array<double, 3>> strays;
  std::vector<Rgba8> colours;
};

std::vector<uint8_t> pack_view(const ViewParts& parts);

/// Unpacks a view. Fails: as read_view() does, for all errors that show without the meaning of the
/// sections.
Result<ViewParts> unpack_view(std::span<const uint8_t> bytes, uint64_t memory_bytes_max);

/// Checks that the parts make a view: scalars in range, sections of the same length, indices
/// inside.
/// Fails: data_loss that names the section, the place and the value.
Status check_view(const ViewParts& parts);

}  // namespace burnish
