#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "client/gl/gl_image.h"
#include "client/model/workspace/workspace.h"

namespace burnish {

/// Draws Workspace::strip: a button that opens it, and its pictures. Needs: the window's OpenGL
/// context outlives it.
class StrengthPictures {
 public:
  /// Draws nothing for a viewer.
  void draw(Workspace& workspace, const PresetInForce& shown);

 private:
  void draw_button(Workspace& workspace, const PresetInForce& shown);
  void draw_row(Workspace& workspace, const PresetInForce& shown);
  const GlImage* image_of(const StrengthStrip::Picture& picture, size_t place);

  struct Held {
    uint64_t number = 0;
    std::unique_ptr<GlImage> image;
  };
  std::array<Held, 3> held_;  // as the graphics card has them
};

}  // namespace burnish
