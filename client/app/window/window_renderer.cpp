#include "client/app/window/window_renderer.h"

namespace burnish {

Result<std::unique_ptr<WindowRenderer>> WindowRenderer::create(const Capabilities& card) {
  auto renderer = std::make_unique<WindowRenderer>();
  if (card.is_software) {
    renderer->processors_ = std::make_unique<RasterPageRenderer>();
    renderer->shown_ = std::make_unique<ShownImage>();
  } else {
    ASSIGN_OR_RETURN(renderer->card_, GlPageRenderer::create());
  }
  return renderer;
}

PageRenderer& WindowRenderer::pages() {
  if (card_) return *card_;
  return *processors_;
}

void WindowRenderer::set_smooth(bool is_smooth) {
  if (processors_)
    processors_->set_sampling(is_smooth ? RasterSampling::kFour : RasterSampling::kOne);
}

Status WindowRenderer::take_picture() {
  return processors_ ? shown_->put(processors_->picture()) : Status::ok();
}

std::optional<double> WindowRenderer::surface_ms() const {
  if (!processors_) return std::nullopt;
  return processors_->draw_ms();
}

void WindowRenderer::show(const Eigen::Vector2i& lower_left) const {
  if (card_) return card_->show(lower_left);
  shown_->show(lower_left);
}

}  // namespace burnish
