#include <utility>

#include "client/model/workspace.h"

namespace burnish {

void Workspace::look_early(const std::shared_ptr<const Coming>& coming) {
  tasks_.start(
      [this, connection = connection_, coming](const StopToken& stop) -> Tasks::Completion {
        const auto early =
            std::make_shared<Result<RawScan>>(fetch_raw_scan(*connection, coming->wish.scan, [&] {
              return !coming->is_open && !stop.stop_requested();
            }));
        return [this, coming, early] { take_early(coming->wish.name, *early); };
      });
}

// A failure of the server is told by the opening.
void Workspace::take_early(const std::string& session, Result<RawScan>& early) {
  if (!opening_ || has_picture() || !early.is_ok() || !put_into(renderer_, *early).is_ok()) return;
  raw_.emplace(std::move(*early));
  ++pictures_begun_;
  viewport.begin(raw_->box);
  for (const RecentSession& recent : preferences.recent)
    if (recent.server == recent_server() && recent.session == session) see_as_kept(recent.id);
}

bool Workspace::keeps_raw_picture(const Camera& shown) const {
  if (!document_ || document_->is_picture_settled()) return false;
  Camera camera = viewport.camera;
  camera.scene_radius = shown.scene_radius;
  return camera == shown && document_->surface().status().triangles_drawn < raw_triangles_;
}

uint64_t Workspace::server_memory_bytes() const {
  return library_.is_private ? private_server_memory_bytes() : 0;
}

void Workspace::close_raw(const std::filesystem::path& file) {
  if (raw_file_ == file) forget_raw();
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
