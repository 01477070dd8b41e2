#include <algorithm>
#include <utility>

#include "client/model/workspace.h"

namespace burnish {

void Workspace::look_early() {
  tasks_.start([this, coming = coming_, triangles_max = options_.budget.triangles](
                   const StopToken& stop) -> Tasks::Completion {
    const auto is_wanted = [&] {
      return !coming->is_over && !coming->activity->is_cancelled() && !stop.stop_requested();
    };
    const auto early = std::make_shared<Result<RawScan>>(
        fetch_raw_scan(*coming->connection, coming->wish.scan, triangles_max, is_wanted));
    return [this, coming, early] {
      if (coming == coming_) take_early(*early);
    };
  });
}

// A failure of the server is told by the opening.
void Workspace::take_early(Result<RawScan>& early) {
  if (has_picture() || !early.is_ok() || !put_into(renderer_, *early).is_ok()) return;
  raw_.emplace(std::move(*early));
  ++pictures_begun_;
  viewport.begin(raw_->box);
  const auto recent = std::ranges::find_if(preferences.recent, [&](const RecentSession& each) {
    return each.server == recent_server() && each.session == coming_->wish.name;
  });
  if (recent != preferences.recent.end()) see_as_kept(recent->id);
}

bool Workspace::keeps_raw_picture(const Camera& shown) const {
  if (!document_ || document_->is_picture_settled()) return false;
  Camera camera = viewport.camera;
  camera.scene_radius = shown.scene_radius;
  const CutStatus now = document_->surface().status();
  const uint64_t whole = document_->scan().scan.statistics.triangles;
  const bool is_coarser = now.triangles_in_view == 0 ||
                          now.triangles_drawn * whole < now.triangles_in_view * raw_triangles_;
  return camera == shown && raw_triangles_ > 0 && is_coarser;
}

uint64_t Workspace::server_memory_bytes() const {
  return library_.is_private ? private_server_memory_bytes() : 0;
}

void Workspace::close_raw(const std::filesystem::path& file) {
  if (raw_file_ != file) return;
  raw_ && raw_->file != file ? raw_file_.clear() : forget_raw();
}

void Workspace::forget_raw() {
  raw_file_.clear();
  raw_.reset();
  raw_work_.reset();
  raw_depth_ = 0;
  raw_begins_again_ = false;
}

bool Workspace::may_open(const std::filesystem::path& file) const {
  return !document_ && !opening_ && (raw_file_.empty() || raw_file_ == file);
}

Status Workspace::draw() {
  is_drawn_ = document_ != nullptr;
  if (document_) return viewport.draw(renderer_, *document_);
  if (!raw_) return Status::ok();
  DrawStyle style = style_of(*raw_);
  style.lighting = viewport.options.lighting;
  return renderer_.draw(viewport.camera, viewport.size(), style, raw_->patches);
}

}  // namespace burnish
