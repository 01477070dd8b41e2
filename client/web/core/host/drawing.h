#pragma once

#include <memory>

#include "client/web/core/front.h"

namespace burnish {

/// Makes what draws the page's pictures. Puts into `host` how they are shown, and into `options`
/// what they may cost. core.wasm draws with the graphics card (client/web/core/card),
/// core_raster.wasm with the processor (client/web/core/raster). Fails: internal_error.
Result<std::unique_ptr<PageRenderer>> begin_drawing(FrontHost& host, WorkspaceOptions& options);

/// The bytes of pages that a page keeps in memory, and again for drawing: a browser's page has less
/// memory than a program.
inline constexpr uint64_t kPageMemoryBytes = 200'000'000;

}  // namespace burnish
