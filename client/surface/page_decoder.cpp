#include "client/surface/page_decoder.h"

#include <utility>

#include "common/base/check.h"
#include "common/pages/page_codec.h"

namespace burnish {

DecodedPage decode_in_scan(const EncodedPage& encoded, const PageHead& head) {
  Result<Page> page = decode_page(encoded.bytes);
  if (!page.is_ok()) return {encoded.id, page.status(), {}};
  const Status fits = check_page_in_scan(*page, encoded.id, head);
  if (!fits.is_ok()) return {encoded.id, fits, {}};
  PageMesh mesh = make_page_mesh(*page, head.grid);
  return {encoded.id, std::move(page), std::move(mesh)};
}

PageDecoder::PageDecoder(PageHead head, std::function<void()> on_news)
    : desk_(make_page_desk(std::move(head), std::move(on_news))) {}

void PageDecoder::decode(PageId page, std::span<const uint8_t> bytes) {
  BURNISH_CHECK(has_room() && !has(page), "a page is decoded once");
  known_.insert(page);
  desk_->put({page, {bytes.begin(), bytes.end()}});
}

std::vector<DecodedPage> PageDecoder::take() {
  std::vector<DecodedPage> taken = desk_->take();
  for (const DecodedPage& page : taken) known_.erase(page.id);
  return taken;
}

}  // namespace burnish
