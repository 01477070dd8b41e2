#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/scratch_space.h"
#include "common/base/status.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/pictures/level_seams.h"
#include "common/pages/page_file.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

struct UnfinishedSheets;

/// A scan whose sheets are made.
struct SheetsInput {
  const TexturedSurface& surface;
  const PageFile& pages;                 ///< of the same scan
  std::string name;                      ///< for messages
  const LevelledSeams* seams = nullptr;  ///< of the surface; null: they stay
};

struct SheetsOptions {
  int threads = 0;                      ///< 0: all cores
  PreparationBudget* budget = nullptr;  ///< what it may take; null: what the machine has
  ScratchSpace space;                   ///< of arrays that go with the scan's triangles
  uint64_t held_bytes = 0;              ///< of memory that the scan takes beside it
  /// Holds what a cancelled build of these pages has made. This build goes on from there, and
  /// leaves what it has made itself if it is cancelled. Needs: the same scan, seams and path. Null:
  /// nothing is kept.
  UnfinishedSheets* unfinished = nullptr;
};

/// The cost and the result of making sheets.
struct SheetsReport {
  struct Level {
    uint64_t pages = 0;
    uint64_t texels = 0;  ///< of all sheets
    double seconds = 0;
  };
  std::vector<Level> levels;    ///< the finest first
  uint64_t pictures = 0;        ///< that were read
  double used_texels = 0;       ///< of the pictures, inside the triangles
  uint64_t lost_triangles = 0;  ///< of level 0, that the scan does not have
  double picture_seconds = 0;
  uint64_t kept_pages = 0;  ///< of cancelled builds before
};

/// Writes the sheet file of a scan (common/sheets/sheet_format.h). Sheets of level 0 are baked from
/// the pictures, about as dense as these are, in linear light times the factors of levelled seams;
/// those of coarser levels from the finer ones. A
/// picture that is missing or damaged counts as white, so that its materials show their factor.
/// Returns whether the scan shows a picture; without one there is no file. Asks the budget before
/// it takes memory or disk. Pictures lie in files without names in the folder of `path`; none is in
/// memory as a whole. Fails: resource_exhausted naming bytes and limit; data_loss (a damaged page);
/// a damaged picture if the textures refuse damage; cancelled; what writing says. Then the path is
/// as it was. Deterministic: the same bytes for any number of threads, and of builds that were
/// cancelled before.
Result<bool> build_sheets(const SheetsInput& scan, const std::filesystem::path& path,
                          const SheetsOptions& options = {}, const Progress& progress = {},
                          SheetsReport* report = nullptr);

}  // namespace burnish
