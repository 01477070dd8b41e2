#include <utility>

#include "client/model/viewport.h"

namespace burnish {

static constexpr double kHomeAzimuth = 25, kHomeElevation = 20;  // degrees
static constexpr double kFocusNearer = 0.5;                      // of the distance

void Viewport::frame_all() {
  camera = burnish::frame_all(camera, box_, size_.aspect());
  framed_ = camera;
}

void Viewport::set_size(const ImageSize& size) {
  if (std::exchange(size_, size) == size || !framed_) return;
  framed_->scene_radius = camera.scene_radius;  // it changes in every picture
  if (framed_ == camera) frame_all();
}

void Viewport::go_home() {
  camera.azimuth_degrees = kHomeAzimuth;
  camera.elevation_degrees = kHomeElevation;
  frame_all();
}

void Viewport::set_up(UpAxis up) {
  camera.up = up;
  frame_all();
}

void Viewport::show_from(StandardView view) {
  camera = seen_from(camera, view);
  frame_all();
}

void Viewport::add_bookmark() {
  if (bookmarks.size() < kBookmarksMax) bookmarks.push_back(camera);
}

void Viewport::focus() {
  if (hover_) camera.target = hover_->displaced;
}

void Viewport::focus_nearer(const Document& document) {
  if (pointer_) look_at(*pointer_, document);
  if (!hover_) return;
  focus();
  const Eigen::Vector2d middle(0.5 * size_.width, 0.5 * size_.height);
  camera = zoomed_at(camera, size_, middle, kFocusNearer);
}

}  // namespace burnish
