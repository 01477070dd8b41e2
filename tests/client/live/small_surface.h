#pragma once

#include <memory>
#include <vector>

#include "client/live/surface_frame.h"
#include "common/pages/directory.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {

/// The head of the small pages, as far as frames need it.
PageHead small_head();
int small_depth();

/// Returns a small page as a client holds it.
std::shared_ptr<const Page> small_page(PageId page);
std::vector<std::shared_ptr<const Page>> small_pages_of(const std::vector<PageId>& pages);

/// Returns where a client has the vertices of a page after an exact frame of what the sampler has.
std::vector<Vec3f> moved(const PageSampler& sampler, PageId page);

/// Says whether a frame has all its pages where the sampler has them, and no others.
bool shows(const SurfaceFrame& frame, const PageSampler& sampler, const std::vector<PageId>& pages);

}  // namespace burnish
