#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/base/loop_progress.h"
#include "common/base/mapped_file.h"
#include "common/base/progress.h"
#include "common/mesh/mesh_io.h"
#include "server/memory/library_budget.h"

namespace burnish {

/// Reads a stored file into the budget's scratch space, under the name that its user knows. Asks
/// the budget for what its pictures take. Needs: budget.ask_to_read(). Fails: as
/// read_stored_mesh(); cancelled.
inline Result<std::shared_ptr<const StoredMesh>> read_original(const std::filesystem::path& path,
                                                               MeshFormat format,
                                                               const std::string& name,
                                                               LibraryBudget& budget,
                                                               const Progress& progress) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  LoopProgress rows(progress, "reading", 0, 0);
  const PictureBudget pictures = [&](uint64_t bytes) -> Status {
    if (!rows.goes_on(0)) return cancelled("reading the file was cancelled");
    return bytes == 0 ? Status::ok() : budget.ask_for_picture(bytes);
  };
  ASSIGN_OR_RETURN(StoredMesh mesh,
                   read_stored_mesh(file.bytes(), format, name, budget.space(), pictures));
  return std::make_shared<const StoredMesh>(std::move(mesh));
}

}  // namespace burnish
