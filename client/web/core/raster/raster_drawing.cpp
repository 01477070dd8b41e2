// Pictures that the processor draws, where the browser has no graphics card for the page.

#include "client/raster/raster_page_renderer.h"
#include "client/web/core/host/drawing.h"
#include "client/web/core/host/imports.h"

namespace burnish {

Result<std::unique_ptr<PageRenderer>> begin_drawing(FrontHost& host, WorkspaceOptions& options) {
  auto processor = std::make_unique<RasterPageRenderer>();
  RasterPageRenderer& renderer = *processor;
  host.show = [&renderer] {
    const Image& picture = renderer.picture();
    host_show_picture(picture.rgb.data(), picture.size.width, picture.size.height);
  };
  host.is_drawing = [] { return false; };  // the core waits for its own pictures
  host.set_smooth = [&renderer](bool is_smooth) {
    renderer.set_sampling(is_smooth ? RasterSampling::kFour : RasterSampling::kOne);
  };
  host.draw_ms = [&renderer] { return renderer.draw_ms(); };
  options.budget = processor_budget();
  options.budget.resident_bytes = kPageMemoryBytes;
  return std::unique_ptr<PageRenderer>(std::move(processor));
}

}  // namespace burnish
