// The renderer of a build without OpenGL.

#include "client/pictures/lone_renderer.h"
#include "client/raster/raster_page_renderer.h"

namespace burnish {

LoneRenderer::LoneRenderer() : renderer_(std::make_unique<RasterPageRenderer>()) {}

}  // namespace burnish
