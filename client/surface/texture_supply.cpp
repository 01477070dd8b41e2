#include "client/surface/texture_supply.h"

#include <utility>

#include "common/sheets/sheet_directory.h"

namespace burnish {

Result<std::unique_ptr<TextureSupply>> TextureSupply::open(const SheetsDescription& description,
                                                           TextureOptions options) {
  ASSIGN_OR_RETURN(SheetHead head, decode_sheet_head(description.head, options.pages));
  if (head.pages_fingerprint != options.pages_fingerprint)
    return failed_precondition("the scan's sheets belong to other pages");
  std::unique_ptr<TextureSupply> textures(
      new TextureSupply(std::move(head), description.version, std::move(options)));
  for (const PagePart& part : description.blocks)
    textures->on_arrival({PageItem::of_sheet_block(part.number, description.version), part.bytes},
                         {});
  return textures;
}

TextureSupply::TextureSupply(SheetHead head, uint64_t version, TextureOptions options)
    : loader_(std::move(head), options.pages, options.bytes_max, version),
      desk_(make_texture_desk(options.pages.grid, std::move(options.on_news))) {}

const PageRequests::Plan& TextureSupply::look(const PageLoader& pages,
                                              std::span<const PageId> drawn, const LinkSpeed& link,
                                              Time now) {
  const SheetQuestion question{.view = pages.view(),
                               .largest_move = pages.frame().largest_move,
                               .drawn = drawn,
                               .is_at_rest = pages.is_at_rest(),
                               .may_ask = pages.is_prompt(),
                               .link = link};
  loader_.look(question, pages.known(), now);
  const auto page_of = [&](PageId page) -> std::shared_ptr<const Page> {
    const CachedPage* cached = pages.cache().find(page);
    return cached == nullptr ? nullptr : cached->page;
  };
  for (EncodedTexture& job : loader_.take_jobs(page_of)) desk_->put(std::move(job));
  return loader_.requests();
}

void TextureSupply::on_arrival(PageSource::Arrival arrival, Time now) {
  loader_.on_arrival(arrival.item, std::move(arrival.bytes), now);
}

void TextureSupply::take_decoded(Time now) {
  for (DecodedTexture& decoded : desk_->take()) loader_.on_decoded(std::move(decoded), now);
}

void TextureSupply::on_link_made() {
  has_told_ = false;
  loader_.on_link_made();
}

std::string TextureSupply::take_failures() {
  const std::vector<GivenUpItem> items = loader_.take_given_up();
  if (items.empty() || std::exchange(has_told_, true)) return {};
  return std::to_string(items.size()) +
         " pieces of the texture could not be fetched: " + items.front().last_failure.message();
}

}  // namespace burnish
