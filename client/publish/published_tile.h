#pragma once

#include <string>

#include "client/live/surface_frame.h"
#include "common/pages/page.h"

namespace burnish {

/// Returns a page's move as a key frame that shows this page alone has it
/// (common/page_frames/page_frame_header.h): the number of values, u16, and the frame's body before
/// compression, of kind vertices. So the body of a frame of many pages is made of their tiles'
/// streams. Empty if nothing has moved and the gain is 1. Needs: a move of an exact frame.
std::string published_tile(const Page& page, const PageMove& move);

/// Returns a tile as a publication has it: in zlib's format (RFC 1950), which browsers unpack
/// themselves. An empty one stays empty.
std::string pack_tile(const std::string& tile);

}  // namespace burnish
