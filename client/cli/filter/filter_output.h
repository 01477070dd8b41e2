#pragma once

#include <string>
#include <vector>

#include "client/cli/filter/filter_file.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"
#include "common/mesh/rewrite/write_plan.h"

namespace burnish {

/// The formats of a run, and the way between them.
struct FilterFormats {
  MeshFormat in, out;
  WritePlan plan;
  bool packs() const { return plan.way == WriteWay::kPack; }
};

/// Refuses wrong files before the long work begins. Fails: invalid_argument (a format, OUT is IN
/// without --force); already_exists (a file beside OUT, without --force); as OUT cannot be written.
Result<FilterFormats> check_filter_paths(const FilterOptions& options, const FilterPaths& paths);

/// Fails: failed_precondition if IN shows no picture; as read_textured_surface().
Status check_has_pictures(const FilterPaths& paths, MeshFormat format);

/// Returns the attributes of IN that OUT will not have, and warns of them on stderr. `mesh` is IN.
Result<std::vector<std::string>> tell_left_out(const FilterPaths& paths, FilterFormats formats,
                                               const TriangleMesh& mesh);

/// Writes the solved surface in the format of OUT, with the files beside it. Pictures get edited
/// colours, but for the scan's own where OUT lies in their folder without --force. Fails: as
/// write_moved_mesh(), place_files_of(), write_packed_mesh() and write_spread_mesh().
Status write_surface(const FilterOptions& options, const FilterPaths& paths, FilterFormats formats,
                     const MovedMesh& moved, PictureWork& pictures);

/// Returns what OUT does not have of edited colours, and warns of it on stderr. Fails: as IN cannot
/// be read.
Result<std::vector<std::string>> tell_colours_left_out(const FilterPaths& paths,
                                                       FilterFormats formats, const SeamWish& seams,
                                                       const PictureReport& pictures);

}  // namespace burnish
