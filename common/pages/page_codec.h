#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page.h"

namespace burnish {

/// Packs a page in the format of page_format.h. The same page gives the same bytes.
/// Decoded again, vertices and triangles come in another order: border vertices stay first, a
/// triangle stays in its patch and keeps its orientation, but may begin at another vertex. Normals
/// are rounded. Positions, colours and patches are exact.
/// Needs: check_page() is ok.
std::vector<uint8_t> encode_page(const Page& page);

/// Safe for any bytes. The page passes check_page(). Fails: data_loss that names the damage;
/// unimplemented (another version).
Result<Page> decode_page(std::span<const uint8_t> bytes);

}  // namespace burnish
