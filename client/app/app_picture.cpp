// The part of App that draws the picture of the surface, and lines over it.

#include "client/app/app.h"
#include "client/app/escape.h"
#include "client/app/places.h"
#include "client/app/theme.h"

namespace burnish {

static double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

Status App::draw() {
  const ImageSize size = window_->framebuffer_size();
  if (size.width < kImageSidePixelsMin || size.height < kImageSidePixelsMin) return Status::ok();
  window_->begin_frame();
  close_lists_at_escape();
  draw_panels();
  clear_window();
  const Status drawn = workspace_->has_picture() ? draw_picture() : Status::ok();
  window_->end_frame();
  write_places();
  return drawn;
}

// Draws the picture between the panels, if they leave room.
Status App::draw_picture() {
  if (!check_image_size(picture_.size).is_ok()) return Status::ok();
  const auto begun_at = std::chrono::steady_clock::now();
  workspace_->viewport.set_size(picture_.size);
  RETURN_IF_ERROR(workspace_->look());
  RETURN_IF_ERROR(draw_surface(begun_at));
  const int bottom = window_->framebuffer_size().height - picture_.y - picture_.size.height;
  renderer_->show({picture_.x, bottom});
  return Status::ok();
}

// Draws the surface again if its picture has changed.
Status App::draw_surface(std::chrono::steady_clock::time_point begun_at) {
  const Document* const document = workspace_->document();
  Shown now{workspace_->pictures_begun(),
            document == nullptr,
            0,
            picture_.size,
            workspace_->viewport.camera,
            {},
            is_smooth()};
  if (document) {
    now.changes = document->picture_changes();
    now.style = workspace_->viewport.style(*document);
  }
  if (now == shown_ || keeps_raw_picture()) return Status::ok();
  shown_ = std::move(now);
  // One of the background alone takes no time, and must not hold the surface up.
  const bool has_surface = document && !document->surface().patches().empty();
  renderer_->set_smooth(shown_.is_smooth);
  const auto surface_at = std::chrono::steady_clock::now();
  RETURN_IF_ERROR(workspace_->draw());
  if (renderer_->has_rough_pictures()) surface_ms_ = milliseconds_since(surface_at);
  RETURN_IF_ERROR(renderer_->take_picture());
  if (!has_surface || is_slower_than_moving()) return Status::ok();
  begun_at_ = begun_at;
  drawn_.put();
  return Status::ok();
}

// Smooth edges take the processors twice the time, so they are for pictures at rest.
bool App::is_smooth() const {
  return !renderer_->has_rough_pictures() ||
         (is_picture_settled() && workspace_->viewport.camera == shown_.camera);
}

// Such a picture says nothing about how many triangles a moving one may have.
bool App::is_slower_than_moving() const {
  return renderer_->has_rough_pictures() && shown_.is_smooth;
}

// The raw scan's picture stays until that of its session is as fine, or the user turns it.
bool App::keeps_raw_picture() const {
  const Document* const document = workspace_->document();
  if (!document || !shown_.is_raw || document->is_picture_settled()) return false;
  Camera camera = workspace_->viewport.camera;
  camera.scene_radius = shown_.camera.scene_radius;
  return camera == shown_.camera && picture_.size == shown_.size;
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
