#include <memory>
#include <string>
#include <utility>

#include "client/model/document.h"
#include "client/surface/texture_supply.h"

namespace burnish {

static constexpr int kTextureRenewalsMax = 3;  // a server that always fails is asked no more

// Edits that the server has not acknowledged change no sheets. Older servers tell a protection as
// cell fields.
Document::Seams Document::seams_now() const {
  Seams seams{told_.settings.texture.level_seams, {}};
  if (seams.amount == 0) return seams;
  for (const HistoryEntry& entry : history_)
    if (entry.enabled && (entry.kind == EditKind::kProtect || entry.kind == EditKind::kCellFields))
      seams.protects.push_back(entry.number);
  return seams;
}

// One finding at a time: the newest wish is looked at when it ends.
void Document::follow_seams() {
  if (seams_asked_ && !is_finding_textures_ && *seams_asked_ != seams_now()) find_textures();
}

// A server may have to bake the sheets first, so nobody waits for them. Vertices' colours come from
// the pictures too: a scan without colours has no sheets. An older server knows none.
void Document::find_textures() {
  if (!has_textures()) return;
  is_finding_textures_ = true;
  seams_asked_ = seams_now();
  tasks_.start([this, alive = std::weak_ptr(alive_), connection = opened_.connection,
                scan = opened_.session.scan_id,
                session = seams_asked_->amount > 0 ? opened_.session.id : std::string()](
                   const StopToken& stop) -> Tasks::Completion {
    const auto goes_on = [&](std::string_view, double) { return !stop.stop_requested(); };
    const auto found = connection->describe_sheets(scan, goes_on, session);
    return [this, alive, found] {
      if (!alive.expired()) take_textures(found);
    };
  });
}

void Document::take_textures(const Result<SheetsDescription>& found) {
  is_finding_textures_ = false;
  has_no_textures_yet_ = !found.is_ok();
  if (found.is_ok())
    show_textures(*found);
  else if (found.status().code() != StatusCode::kUnimplemented)
    log_.failure("textures", found.status());
  follow_seams();
}

// A link that was lost may have taken the last finding with it.
void Document::retry_textures() {
  if (has_no_textures_yet_ && !is_finding_textures_) find_textures();
}

// Another server of a fleet has no sheets until somebody describes them, nor one whose file is
// damaged, or whose levelled sheets had to make room.
void Document::renew_textures() {
  if (is_finding_textures_ || texture_renewals_left_ == 0 || !surface_->take_sheet_damage()) return;
  --texture_renewals_left_;
  renews_textures_ = true;
  find_textures();
}

void Document::show_textures(const SheetsDescription& description) {
  const bool renews = std::exchange(renews_textures_, false);
  if (!description.has_sheets()) return;
  const TextureSupply* shown = surface_->textures();
  const bool is_same = shown != nullptr && shown->version() == description.version;
  if (is_same && !renews) return;
  if (!is_same) texture_renewals_left_ = kTextureRenewalsMax;
  auto textures =
      TextureSupply::open(description, {surface_->head(), surface_->pages_fingerprint(),
                                        surface_->texture_bytes_max(), surface_->on_news()});
  if (!textures.is_ok()) return log_.failure("textures", textures.status());
  surface_->set_textures(std::move(*textures));
}

}  // namespace burnish
