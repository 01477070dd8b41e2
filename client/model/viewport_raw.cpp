#include "client/model/viewport.h"

namespace burnish {

void Viewport::begin(const Eigen::AlignedBox3d& box) {
  reset(box);
  paints_ = false;
  camera = {};
  go_home();
}

void Viewport::take_over(const Document& document) {
  paints_ = true;
  box_ = document.box();
  events_.clear();
}

void Viewport::update(const Eigen::AlignedBox3d& box) {
  camera = with_depth_of(camera, box);
  events_.clear();
}

void Viewport::reset(const Eigen::AlignedBox3d& box) {
  gesture_ = Gesture::kIdle;
  value_changes_ = false;
  events_.clear();
  lasso_.clear();
  lasso_wish.reset();
  lasso_is_drawn_ = false;
  bookmarks.clear();
  measure_mode = false;
  leave();
  sent_ring_.reset();
  box_ = box;
}

}  // namespace burnish
