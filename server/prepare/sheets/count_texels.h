#pragma once

#include <string>

#include "common/base/progress.h"
#include "common/base/scratch_array.h"
#include "common/base/status.h"
#include "common/mesh/textures/surface_textures.h"
#include "server/prepare/pages/page_texels.h"

namespace burnish {

/// The texels that a scan's triangles show.
struct CountedTexels {
  ScratchArray<float> of_triangle;  ///< empty where no triangle shows any
  double of_page_max = 0;           ///< about what a sheet of a page shows

  PageTexels for_pages() const { return {of_triangle, of_page_max}; }
};

/// Counts the texels of its picture that each triangle shows, from the headers of the pictures: a
/// sheet's at most, 0 without a picture, and where its header cannot be read. A scan of very large
/// pictures, or of ones that repeat often, has more texels a page instead of ever more pages.
/// `name` is for messages. Fails: cancelled; resource_exhausted, as reading a picture's file does.
Result<CountedTexels> count_texels(const SurfaceTextures& textures, const std::string& name,
                                   const ScratchSpace& space, const Progress& progress);

}  // namespace burnish
