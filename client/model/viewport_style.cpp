#include "client/model/viewport.h"
#include "client/tools/colours.h"

namespace burnish {

static const Vec3f kMirroredRing(0.75f, 0.75f, 0.75f);  // sRGB

static Colouring colouring_of(ColourBy colour) {
  switch (colour) {
    case ColourBy::kBeta:
    case ColourBy::kCurvature:
      return Colouring::kCells;
    case ColourBy::kDisplacement:
      return Colouring::kDisplacement;
    case ColourBy::kScan:
      return Colouring::kScan;
    case ColourBy::kNothing:
      break;
  }
  return Colouring::kClay;
}

DrawStyle Viewport::style(const Document& document) const {
  DrawStyle style;
  style.flat = options.flat;
  style.wireframe = options.wireframe;
  style.colouring = colouring_of(document.colour());
  style.displacement_range = options.displacement_range;
  style.original = hold_original;
  style.lighting = options.lighting;
  style.split = options.split ? options.split_at : 0;
  style.faded = document.link() == LinkState::kLost || document.link() == LinkState::kEnded;
  const BrushTool& brush = document.brush();
  const double beta = brush.is_drawing() ? brush.stroke().brush.beta : brush.brush.beta;
  style.tint = blue_to_red(signed_part_of_beta(beta));
  const auto curve = static_cast<size_t>(brush.brush.curve);
  if (curve > 0 && curve <= document.palette().curves.size())
    style.tint = colour_of_hex(document.palette().curves[curve - 1].colour);
  if (hover_ && pointer_ && !navigate_mode && !measure_mode && !document.is_viewer()) {
    const Vec3d& at = hover_->original;
    style.rings.push_back({at, brush.brush.radius, Vec3f(1, 1, 1)});
    if (document.mirror)
      style.rings.push_back({mirrored(at, *document.mirror), brush.brush.radius, kMirroredRing});
  }
  for (const PresentUser& user : document.people().present)
    if (user.ring && user.connection != document.welcome().connection)
      style.rings.push_back({user.ring->centre, user.ring->radius, colour_of_hex(user.colour)});
  return style;
}

}  // namespace burnish
