#include "client/surface/texture_supply.h"

#include <utility>

#include "client/sheets/sheet_loader.h"
#include "client/sheets/texture_decoder.h"
#include "client/surface/desk_thread.h"
#include "common/sheets/sheet_directory.h"

namespace burnish {
namespace {

class LoadedTextures final : public TextureSupply {
 public:
  LoadedTextures(SheetHead head, TextureOptions options)
      : loader_(std::move(head), options.pages, options.bytes_max),
        desk_([grid = options.pages.grid](
                  const EncodedTexture& encoded) { return decode_texture(encoded, grid); },
              std::move(options.on_news)) {}

  const PageRequests::Plan& look(const PageLoader& pages, std::span<const PageId> drawn,
                                 const LinkSpeed& link, Time now) override {
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
    for (EncodedTexture& job : loader_.take_jobs(page_of)) desk_.put(std::move(job));
    return loader_.requests();
  }

  void on_arrival(PageSource::Arrival arrival, Time now) override {
    loader_.on_arrival(arrival.item, std::move(arrival.bytes), now);
  }

  void take_decoded(Time now) override {
    for (DecodedTexture& decoded : desk_.take()) loader_.on_decoded(std::move(decoded), now);
  }

  void on_link_made() override {
    has_told_ = false;
    loader_.on_link_made();
  }
  std::shared_ptr<const PageTexture> texture(PageId page) const override {
    return loader_.texture(page);
  }
  uint64_t changes() const override { return loader_.changes(); }
  bool is_settled() const override { return loader_.is_settled(); }

  std::string take_failures() override {
    const std::vector<GivenUpItem> items = loader_.take_given_up();
    if (items.empty() || std::exchange(has_told_, true)) return {};
    return std::to_string(items.size()) +
           " pieces of the texture could not be fetched: " + items.front().last_failure.message();
  }

 private:
  SheetLoader loader_;
  bool has_told_ = false;  // of failures over this connection
  DeskThread<EncodedTexture, DecodedTexture> desk_;
};

}  // namespace

Result<std::unique_ptr<TextureSupply>> make_texture_supply(const SheetsDescription& description,
                                                           TextureOptions options) {
  ASSIGN_OR_RETURN(SheetHead head, decode_sheet_head(description.head, options.pages));
  if (head.pages_fingerprint != options.pages_fingerprint)
    return failed_precondition("the scan's sheets belong to other pages");
  std::unique_ptr<TextureSupply> textures =
      std::make_unique<LoadedTextures>(std::move(head), std::move(options));
  for (const PagePart& part : description.blocks)
    textures->on_arrival({PageItem::of_sheet_block(part.number), part.bytes}, {});
  return textures;
}

}  // namespace burnish
