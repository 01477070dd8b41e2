#include "client/pictures/lone_renderer.h"

#include "client/gl/capabilities.h"
#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/raster/raster_page_renderer.h"

namespace burnish {

// Processors draw if any step to the card fails.
static std::unique_ptr<PageRenderer> renderer_of_card() {
  if (card_capabilities().is_software) return nullptr;
  auto renderer = GlPageRenderer::create();
  if (!renderer.is_ok()) return nullptr;
  return std::move(renderer).value();
}

LoneRenderer::LoneRenderer() {
  auto context = EglContext::create();
  if (context.is_ok()) {
    context_ = std::move(context).value();
    renderer_ = renderer_of_card();
  }
  if (renderer_) return;
  context_.reset();
  renderer_ = std::make_unique<RasterPageRenderer>();
}

}  // namespace burnish
