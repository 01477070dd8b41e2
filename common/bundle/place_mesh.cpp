#include "common/bundle/place_mesh.h"

#include "common/base/mapped_file.h"
#include "common/bundle/place_files.h"
#include "common/mesh/folder_files.h"
#include "common/mesh/obj_files.h"

namespace burnish {

namespace fs = std::filesystem;

Result<PlacedMesh> place_mesh(const Archive& archive, const ArchivedMesh& mesh,
                              const fs::path& file, bool replaces) {
  PlacedMesh placed{file, {}};
  std::string folder = folder_of(mesh.path);
  if (!folder.empty()) folder += '/';
  std::vector<FileToPlace> beside;
  for (const ArchiveEntry& entry : archive.entries()) {
    if (entry.is_folder() || entry.name == mesh.path) continue;
    if (entry.name.starts_with(folder)) {
      beside.push_back({entry.name, entry.name.substr(folder.size())});
    } else {
      placed.left_out.push_back(entry.name);
    }
  }
  const ArchiveFiles from(archive);
  RETURN_IF_ERROR(place_files(from, beside, file.parent_path(), replaces));
  const FileToPlace itself = {mesh.path, file.filename().string()};
  RETURN_IF_ERROR(place_files(from, {&itself, 1}, file.parent_path(), true));
  return placed;
}

Result<PlacedMesh> place_archive(const Archive& archive, const ArchivedMesh& mesh,
                                 const fs::path& folder, bool replaces) {
  std::vector<FileToPlace> files;
  for (const ArchiveEntry& entry : archive.entries())
    if (!entry.is_folder()) files.push_back({entry.name, entry.name});
  RETURN_IF_ERROR(place_files(ArchiveFiles(archive), files, folder, replaces));
  return PlacedMesh{folder / mesh.path, {}};
}

Status place_files_of(const fs::path& mesh, const fs::path& copy, bool replaces) {
  ASSIGN_OR_RETURN(const MeshFormat format, mesh_format_of_path(mesh));
  const fs::path folder = copy.has_parent_path() ? copy.parent_path() : fs::path(".");
  const fs::path from = mesh.has_parent_path() ? mesh.parent_path() : fs::path(".");
  std::error_code ignored;
  if (format != MeshFormat::kObj || fs::equivalent(from, folder, ignored)) return Status::ok();
  const FolderFiles files(from);
  ASSIGN_OR_RETURN(const MappedFile obj, MappedFile::open(mesh));
  ASSIGN_OR_RETURN(const ObjFiles named,
                   find_obj_files(obj.bytes(), mesh.filename().string(), files));
  std::vector<FileToPlace> beside;
  for (const std::string& path : named.found) beside.push_back({path, path});
  return place_files(files, beside, folder, replaces);
}

}  // namespace burnish
