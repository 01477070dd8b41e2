#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "common/base/progress.h"
#include "common/mesh/io/mesh_io.h"
#include "server/lease/held_file.h"
#include "server/memory/library_budget.h"

namespace burnish {

/// Hears `progress` while a file is read, and asks `budget` for what its pictures take. Needs: both
/// outlive the result.
inline FileBudget reading_budget(LibraryBudget& budget, const Progress& progress) {
  return [&budget, heard = heard_budget(progress, "reading")](uint64_t bytes) -> Status {
    RETURN_IF_ERROR(heard(0));
    return bytes == 0 ? Status::ok() : budget.ask_for_picture(bytes);
  };
}

/// Reads a stored file into the budget's scratch space, under the name that its user knows. Asks
/// the budget for what its pictures take. Needs: budget.ask_to_read(). Fails: as
/// read_stored_mesh(); cancelled.
inline Result<std::shared_ptr<const StoredMesh>> read_original(const std::filesystem::path& path,
                                                               MeshFormat format,
                                                               const std::string& name,
                                                               LibraryBudget& budget,
                                                               const Progress& progress) {
  ASSIGN_OR_RETURN(const HeldFile file, HeldFile::open(path));
  ASSIGN_OR_RETURN(StoredMesh mesh, read_stored_mesh(file.bytes(), format, name, budget.space(),
                                                     reading_budget(budget, progress)));
  return std::make_shared<const StoredMesh>(std::move(mesh));
}

}  // namespace burnish
