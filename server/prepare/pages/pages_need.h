#pragma once

#include <cstdint>
#include <string>

#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

/// Predicts what build_pages() takes, with the scan itself.
/// `arrays_bytes_max` is ScratchSpace::memory_bytes_max(): more arrays than that lie in files.
/// Accuracy: no less than the peak of anonymous memory, and at most half as much again. The file is
/// at most so large.
PreparationNeed predict_pages(const PagesInput& scan, uint64_t arrays_bytes_max = UINT64_MAX);

/// "making pages of 2 triangles takes 5 MiB of memory and a file of 1 MiB".
std::string pages_need_text(const PreparationNeed& need);

}  // namespace burnish
