#include "server/prepare/sheets/unfinished_sheets.h"

#include <algorithm>

namespace burnish {

uint64_t UnfinishedSheets::pages() const {
  return begin + static_cast<uint64_t>(std::ranges::count_if(
                     batch, [](const auto& page) { return page.has_value(); }));
}

uint64_t UnfinishedSheets::memory_bytes() const {
  uint64_t bytes = sizeof(*this);
  for (const auto* kept : {&finer, &made})
    if (*kept) bytes += (*kept)->memory_bytes();
  for (const auto& page : batch) {
    if (!page) continue;
    bytes += sizeof(*page) + page->charts.size();
    for (const auto& sheet : page->sheets) bytes += sheet.size();
  }
  return bytes;
}

uint64_t UnfinishedSheets::scratch_bytes() const {
  uint64_t bytes = pictures ? pictures->tiles.bytes() : 0;
  for (const auto* kept : {&finer, &made})
    if (*kept) bytes += (*kept)->texels() * sizeof(Rgba8);
  return bytes;
}

}  // namespace burnish
