// The part of App that draws the picture of the surface, and lines over it.

#include "client/app/app.h"
#include "client/app/widgets/escape.h"
#include "client/app/widgets/places.h"
#include "client/app/widgets/theme.h"
#include "common/base/limits.h"

namespace burnish {

// Smooth edges take the processors twice the time, so they are for pictures at rest.
static constexpr std::chrono::milliseconds kRest{100};

Status App::draw() {
  const ImageSize size = window_->framebuffer_size();
  if (size.width < kImageSidePixelsMin || size.height < kImageSidePixelsMin) return Status::ok();
  window_->begin_frame();
  close_lists_at_escape();
  draw_panels();
  const auto now = std::chrono::steady_clock::now();
  const bool is_new = shows_surface() && !(is_idle_ && is_surface_at_rest());
  const Status drawn = is_new ? update_surface(now) : Status::ok();
  if (shows_surface()) save_picture_at_rest(now);
  const bool has_new_panels = window_->end_frame();
  if (std::exchange(is_surface_new_, false) || has_new_panels) show_picture();
  write_places();
  return drawn;
}

// The surface lies between the panels, if they leave room.
bool App::shows_surface() const {
  return workspace_->has_picture() && check_image_size(picture_.size).is_ok();
}

void App::show_picture() {
  clear_window();
  const int bottom = window_->framebuffer_size().height - picture_.y - picture_.size.height;
  if (shows_surface()) renderer_->show({picture_.x, bottom});
  window_->show_frame();
}

// Draws the surface again if its picture has changed.
Status App::update_surface(std::chrono::steady_clock::time_point now) {
  workspace_->viewport.set_size(picture_.size);
  RETURN_IF_ERROR(workspace_->look());
  Shown next = next_shown();
  if (!(next == shown_)) changed_at_ = now;
  next.is_smooth = !renderer_->has_rough_pictures() ||
                   (next == shown_ &&
                    (shown_.is_smooth || (is_picture_settled() && now - changed_at_ >= kRest)));
  if (next == shown_ || keeps_raw_picture()) return Status::ok();
  shown_ = std::move(next);
  return draw_surface(now);
}

// Smooth as the last picture is.
App::Shown App::next_shown() const {
  const Document* const document = workspace_->document();
  Shown next{.surface = workspace_->pictures_begun(),
             .is_raw = document == nullptr,
             .size = picture_.size,
             .camera = workspace_->viewport.camera,
             .is_smooth = shown_.is_smooth};
  if (document) {
    next.changes = document->picture_changes();
    next.style = workspace_->viewport.style(*document);
  }
  return next;
}

Status App::draw_surface(std::chrono::steady_clock::time_point begun_at) {
  renderer_->set_smooth(shown_.is_smooth);
  RETURN_IF_ERROR(workspace_->draw());
  RETURN_IF_ERROR(renderer_->take_picture());
  is_surface_new_ = true;
  // One of the background alone takes no time, and must not hold the surface up.
  const Document* const document = workspace_->document();
  const bool has_surface = document && !document->surface().patches().empty();
  if (!has_surface || is_slower_than_moving()) return Status::ok();
  begun_at_ = begun_at;
  drawn_.put();
  return Status::ok();
}

// Such a picture says nothing about how many triangles a moving one may have.
bool App::is_slower_than_moving() const {
  return renderer_->has_rough_pictures() && shown_.is_smooth;
}

// Whether all is drawn, as far as it is here.
bool App::is_surface_at_rest() const {
  return is_picture_settled() && (!shows_surface() || (shown_.is_smooth && next_shown() == shown_));
}

// The raw scan's picture stays until that of its session is as fine, or the user turns it.
bool App::keeps_raw_picture() const {
  return shown_.is_raw && picture_.size == shown_.size &&
         workspace_->keeps_raw_picture(shown_.camera);
}

// Says which surface is the original one, and draws the line between both.
void App::draw_sides() const {
  const ViewOptions& view = workspace_->viewport.options;
  const bool is_original = workspace_->viewport.hold_original;
  if (!(view.split || is_original) || !workspace_->document()) return;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const int middle = split_column(is_original ? 0.5 : view.split_at, picture_.size.width);
  const float x = static_cast<float>(picture_.x + middle) / pixels.x;
  const float top = static_cast<float>(picture_.y) / pixels.y;
  const float bottom = static_cast<float>(picture_.y + picture_.size.height) / pixels.y;
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  const ImU32 dark = ImGui::ColorConvertFloat4ToU32(theme::kOnPicture);
  const float pad = em(0.6f), width = ImGui::CalcTextSize("original").x;
  const float line = bottom - ImGui::GetTextLineHeight() - pad;
  if (is_original) return list->AddText({x - width / 2, line}, dark, "original");
  list->AddLine({x, top}, {x, bottom}, dark, em(0.1f));
  list->AddText({x - width - pad, line}, dark, "original");
  list->AddText({x + pad, line}, dark, "edited");
}

void App::draw_lasso() const {
  const std::vector<Eigen::Vector2d>& pixels = workspace_->viewport.lasso();
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  std::vector<ImVec2> line;
  for (const Eigen::Vector2d& pixel : pixels)
    line.emplace_back((picture_.x + float(pixel.x())) / scale.x,
                      (picture_.y + float(pixel.y())) / scale.y);
  ImGui::GetBackgroundDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()),
                                              ImGui::ColorConvertFloat4ToU32(theme::kBusy),
                                              ImDrawFlags_Closed, em(0.12f));
}

}  // namespace burnish
