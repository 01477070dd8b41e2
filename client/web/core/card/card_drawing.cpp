// Pictures of the graphics card, by WebGL2.

#include "client/gl/capabilities.h"
#include "client/gl/fence.h"
#include "client/gl/gl_page_renderer.h"
#include "client/web/core/host/drawing.h"

namespace burnish {

Result<std::unique_ptr<PageRenderer>> begin_drawing(FrontHost& host, WorkspaceOptions& options) {
  ASSIGN_OR_RETURN(auto card, GlPageRenderer::create());
  static auto* const shown = new Fence();  // behind the last picture; lives as long as the page
  host.show = [&renderer = *card] {
    renderer.show({0, 0});
    shown->put();
  };
  host.is_drawing = [] { return !shown->is_reached(); };
  options.is_software = card_capabilities().is_software;
  options.budget = options.is_software ? software_budget() : PageBudget();
  options.budget.resident_bytes = options.budget.card_bytes = kPageMemoryBytes;
  return std::unique_ptr<PageRenderer>(std::move(card));
}

}  // namespace burnish
