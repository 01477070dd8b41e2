#pragma once

#include <span>

#include "client/raster/page_projection.h"
#include "client/raster/raster_page.h"
#include "client/raster/visibility.h"
#include "client/raster/work_crew.h"
#include "client/scene/page_renderer.h"

namespace burnish {

/// Which surface of the pages, and where.
struct FilledPart {
  ColumnRange columns;
  bool of_original = false;
};

/// Puts all patches into a picture's visibility. Needs: patches inside their pages.
void fill_pages(std::span<const RasterPage> pages, const PageProjection& projection,
                std::span<const PatchRange> patches, const FilledPart& part, WorkCrew& crew,
                Visibility& visibility);

}  // namespace burnish
