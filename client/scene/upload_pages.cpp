#include "client/scene/raw_pages.h"

namespace burnish {

Result<std::vector<PatchRange>> upload_pages(const RawPages& raw, PageRenderer& renderer) {
  const auto count = static_cast<uint32_t>(raw.pages.size());
  renderer.open(raw.space);
  RETURN_IF_ERROR(renderer.reserve(count));
  std::vector<PatchRange> patches;
  for (uint32_t slot = 0; slot < count; ++slot) {
    RETURN_IF_ERROR(renderer.upload_page(slot, raw.pages[slot]));
    patches.push_back({slot, 0, static_cast<uint32_t>(raw.pages[slot].triangles.size())});
  }
  return patches;
}

}  // namespace burnish
