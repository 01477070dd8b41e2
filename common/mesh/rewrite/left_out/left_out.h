#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

/// Names the attributes of a file that write_mesh() leaves out in another format, in a user's
/// words: "normals", "materials", "property quality". At most kLeftOutMax names; the last is then
/// "others". Empty for the file's own format, and for an archive. Names the files beside an
/// archive's mesh too. `mesh` is what read_mesh() made of the file. Fails: as the file cannot be
/// read; cancelled, as `budget` says.
Result<std::vector<std::string>> attributes_left_out(const OriginalFile& original, MeshFormat to,
                                                     const MeshView& mesh,
                                                     const FileBudget& budget = {});

/// Returns whether a file in this format has changed vertex colours. In the original's own format
/// those of glTF do not change, nor those that come from textures. Fails: likewise.
Result<bool> keeps_changed_colours(const OriginalFile& original, MeshFormat to,
                                   const FileBudget& budget = {});

/// Names what a written file does not have of edited colours: all of them if neither vertices nor
/// pictures have them, those of triangles without a picture, pictures that were kept, with the
/// reason, and wanted seams that nobody levelled. Fails: likewise.
Result<std::vector<std::string>> edited_colours_left_out(const OriginalFile& original,
                                                         MeshFormat to, const SeamWish& seams,
                                                         const PictureReport& pictures,
                                                         const FileBudget& budget = {});

/// Returns whether the scan's own format lacks this too: edited colours that pictures cannot have.
bool is_lost_in_any_format(std::string_view name);

inline constexpr size_t kLeftOutMax = 20;

/// Joins the names: "normals, materials".
std::string left_out_text(const std::vector<std::string>& names);

}  // namespace burnish
