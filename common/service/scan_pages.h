#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/base/record.h"

namespace burnish {

/// Limit of the blocks and pages of one request.
inline constexpr size_t kPagePartsPerFetchMax = 64;

/// The directory blocks and the pages that a client wants to have.
struct PagesWish {
  std::string scan;  ///< name, id, or the beginning of one id
  std::vector<uint32_t> blocks;
  std::vector<uint32_t> pages;
};
BURNISH_RECORD(PagesWish, scan, blocks, pages)

/// An encoded directory block or page, in the format of common/pages/page_format.h.
struct PagePart {
  uint32_t number = 0;
  std::vector<uint8_t> bytes;
};

/// An encoded head and the coarsest blocks of the directory.
struct PagesDescription {
  std::vector<uint8_t> head;
  std::vector<PagePart> blocks;  ///< rising; the last holds the root
};

}  // namespace burnish
