#include "client/model/document.h"
#include "client/surface/texture_supply.h"

namespace burnish {

// A server may have to bake the sheets first, so nobody waits for them. Vertices' colours come from
// the pictures too: a scan without colours has no sheets. An older server knows none.
void Document::find_textures() {
  if (!has_colours() || surface_->texture_bytes_max() == 0) return;
  is_finding_textures_ = true;
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                scan = opened_.session.scan_id](const StopToken& stop) -> Tasks::Completion {
    const auto goes_on = [&](std::string_view, double) { return !stop.stop_requested(); };
    const auto found = connection->describe_sheets(scan, goes_on);
    return [this, alive, found] {
      if (alive.expired()) return;
      is_finding_textures_ = false;
      if (found.is_ok()) return show_textures(*found);
      if (found.status().code() != StatusCode::kUnimplemented)
        log_.failure("textures", found.status());
    };
  });
}

// Another server of a fleet has no sheets until somebody describes them, nor one whose file is
// damaged.
void Document::renew_textures() {
  if (!surface_->take_sheet_damage() || is_finding_textures_ || texture_renewals_left_ == 0) return;
  --texture_renewals_left_;
  find_textures();
}

void Document::show_textures(const SheetsDescription& description) {
  if (!description.has_sheets()) return;
  auto textures =
      TextureSupply::open(description, {surface_->head(), surface_->pages_fingerprint(),
                                        surface_->texture_bytes_max(), surface_->on_news()});
  if (!textures.is_ok()) return log_.failure("textures", textures.status());
  surface_->set_textures(std::move(*textures));
}

}  // namespace burnish
