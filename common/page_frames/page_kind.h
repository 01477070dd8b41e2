#pragma once

#include <cstddef>
#include <cstdint>

namespace burnish {

/// The kind of a page's values. All frames of a stream have one kind.
enum class PageFrameKind : uint8_t {
  kVertices,  ///< the displacement of each vertex, in the page's order
  kCorners,   ///< the displacement of the corners of the vertices' cells (page_corners.h)
};

/// Returns the largest number of bytes that the key of a page takes in a frame, before compression.
size_t page_key_bytes_max(uint32_t values);

/// Returns the kind that likely takes fewer bytes. Takes the values of all shown pages, if the
/// pages had this kind.
PageFrameKind cheaper_kind(uint64_t vertices, uint64_t corners);

}  // namespace burnish
