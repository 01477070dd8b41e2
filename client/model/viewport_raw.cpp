#include "client/model/viewport.h"

namespace burnish {

void Viewport::begin(const Eigen::AlignedBox3d& box) {
  reset(box);
  paints_ = false;
  camera = {.azimuth_degrees = 25, .elevation_degrees = 20};
  frame_all(box);
}

void Viewport::take_over(const Document& document) {
  paints_ = true;
  diagonal_ = document.diagonal();
  events_.clear();
}

void Viewport::frame_all(const Eigen::AlignedBox3d& box) {
  camera = burnish::frame_all(camera, box, size_.aspect());
}

void Viewport::update(const Eigen::AlignedBox3d& box) {
  camera = with_depth_of(camera, box);
  events_.clear();
}

void Viewport::reset(const Eigen::AlignedBox3d& box) {
  gesture_ = Gesture::kIdle;
  value_changes_ = false;
  events_.clear();
  bookmarks.clear();
  leave();
  sent_ring_.reset();
  diagonal_ = box.diagonal().norm();
}

}  // namespace burnish
