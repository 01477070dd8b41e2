#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/cli/filter/filter_options.h"
#include "common/base/record.h"
#include "common/base/status.h"
#include "common/edit/edit.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"

namespace burnish {

/// The end of one file.
struct FilteredFacts {
  size_t vertices = 0, triangles = 0;
  int depth = 0;
  int32_t corners = 0;
  int cycles = 0;
  bool converged = false;
  double distance = 0;           ///< estimated to convergence, a fraction of the box's diagonal
  std::optional<double> volume;  ///< over the scan's; nothing unless it is to be kept
  double seconds = 0;
  std::vector<std::string> left_out;  ///< attributes of IN that OUT does not have
  PictureReport pictures;             ///< of IN, with edited colours
};
BURNISH_RECORD(FilteredFacts, vertices, triangles, depth, corners, cycles, converged, distance)

/// The files of one run.
struct FilterPaths {
  std::filesystem::path in, out;
  std::filesystem::path report;  ///< empty: none
  std::string out_name;          ///< of `out`, for messages
};

/// Reads a mesh, applies the filter and `edits`, solves and writes. Warns on stderr.
/// Fails: as the files cannot be read and written; invalid_argument; resource_exhausted.
Result<FilteredFacts> filter_file(const FilterOptions& options, const std::vector<Edit>& edits,
                                  const FilterPaths& paths);

}  // namespace burnish
