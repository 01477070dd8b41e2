#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/files/files_beside.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/mesh_format.h"
#include "common/mesh/rewrite/moved/colour_edit.h"
#include "common/mesh/rewrite/pictures/level_seams.h"

namespace burnish {

/// Says what became of the pictures of a scan whose colours are edited.
struct PictureReport {
  uint32_t pictures = 0;            ///< that edited triangles show
  uint32_t changed = 0;             ///< that are written with other texels
  uint64_t texels = 0;              ///< that changed
  uint64_t shared_texels = 0;       ///< of these: shown by several triangles, whose mean they get
  uint64_t bare_triangles = 0;      ///< edited ones that show no picture
  std::vector<std::string> kept;    ///< pictures that edits should change, and why they do not
  std::vector<std::string> notes;   ///< what else is different in a changed picture
  std::optional<SeamReport> seams;  ///< if they were levelled
};

/// "2 of 3 pictures changed, 81220 texels", and the notes; empty without pictures.
std::string text_of(const PictureReport& report);

/// The work on pictures while a scan is written.
struct PictureWork {
  FileBudget budget = {};  ///< hears memory before it is taken, and 0 often; null: none
  PictureReport report = {};
};

/// A picture with other texels.
struct EditedPicture {
  std::string path;    ///< among the files beside the mesh; empty: inside its file
  uint32_t image = 0;  ///< of a glTF file
  std::vector<uint8_t> bytes;
};

/// Writes the pictures again that edited triangles show (texel_changes.h), with level seams if the
/// edit wants it (level_seams.h). A picture that cannot be
/// written stays, and the report says why: it is missing or damaged, it repeats over the surface,
/// or its kind. Fails: as level_seams(); resource_exhausted; cancelled; as the budget does.
Result<std::vector<EditedPicture>> edit_pictures(const TexturedSurface& surface,
                                                 const ColourEdit& edit, PictureWork& work);

/// A mesh file whose pictures may be edited.
struct PicturesSource {
  std::span<const uint8_t> bytes;
  MeshFormat format = MeshFormat::kPly;
  std::string name;  ///< for messages
  MeshSurroundings beside;
};

/// Does edit_pictures() for a mesh file. Nothing is edited without changed colours, or if `work` is
/// null. Fails: as it does; as read_textured_surface().
Result<std::vector<EditedPicture>> edit_pictures_of(const PicturesSource& source,
                                                    const ColourEdit& edit, PictureWork* work);

}  // namespace burnish
