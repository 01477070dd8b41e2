#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/sheets/sheet_file.h"
#include "server/prepare/sheets/build_sheets.h"
#include "server/prepare/sheets/decode_pictures.h"
#include "server/prepare/sheets/level_sheets.h"
#include "server/prepare/sheets/page_maker.h"

namespace burnish {

/// Holds what a cancelled build_sheets() has made, for the next one of the same scan. It lies in
/// files without names and in the temporary file of the writer, so no later process takes it for
/// whole.
struct UnfinishedSheets {
  uint64_t pages_fingerprint = 0;  ///< of the pages that it belongs to
  std::optional<DecodedPictures> pictures;
  std::optional<SheetFileWriter> file;  ///< has the pages before `begin`
  std::optional<LevelSheets> finer;     ///< the level below; nothing at level 0
  std::optional<LevelSheets> made;      ///< the level that is made; nothing before it begins
  int level = 0;
  PageId begin = 0;                               ///< of the batch that is made
  std::vector<std::optional<EncodedPage>> batch;  ///< those of its pages that are made
  SheetsReport report;

  uint64_t pages() const;         ///< that are made
  uint64_t memory_bytes() const;  ///< about
  uint64_t scratch_bytes() const;
};

}  // namespace burnish
