#pragma once

#include <memory>

#include "client/scene/page_renderer.h"

namespace burnish {

/// A renderer without a window: OpenGL with a graphics card, else the processors, which draw scans
/// many times faster than OpenGL without a card does. OpenGL's is used on the thread that made it.
class LoneRenderer {
 public:
  LoneRenderer();

  PageRenderer& operator*() const { return *renderer_; }
  PageRenderer* operator->() const { return renderer_.get(); }
  bool has_card() const { return context_ != nullptr; }

 private:
  std::shared_ptr<void> context_;  // of OpenGL; outlives the renderer
  std::unique_ptr<PageRenderer> renderer_;
};

}  // namespace burnish
