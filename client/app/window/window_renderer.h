#pragma once

#include <memory>
#include <optional>

#include "client/gl/capabilities.h"
#include "client/gl/gl_page_renderer.h"
#include "client/gl/shown_image.h"
#include "client/raster/raster_page_renderer.h"

namespace burnish {

/// Draws the surface in a window: OpenGL with a graphics card, else the processors, whose picture
/// OpenGL only shows. Needs: the window's context is current, and outlives this object.
class WindowRenderer {
 public:
  /// Fails: internal_error when the driver refuses a shader.
  static Result<std::unique_ptr<WindowRenderer>> create(const Capabilities& card);

  PageRenderer& pages();

  /// Says how smooth edges are from the next picture on. A card's are always smooth.
  void set_smooth(bool is_smooth);
  /// Returns whether pictures differ by set_smooth().
  bool has_rough_pictures() const { return processors_ != nullptr; }

  /// Takes what pages() has drawn. Fails: resource_exhausted.
  Status take_picture();
  /// Returns how long processors take for that picture alone; nothing with a card.
  std::optional<double> surface_ms() const;
  /// Copies that picture into the window's own buffer, with its lower left corner at this place.
  void show(const Eigen::Vector2i& lower_left) const;

 private:
  std::unique_ptr<GlPageRenderer> card_;
  std::unique_ptr<RasterPageRenderer> processors_;
  std::unique_ptr<ShownImage> shown_;  // of the processors
};

}  // namespace burnish
