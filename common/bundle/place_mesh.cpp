#include "common/bundle/place_mesh.h"

#include "common/base/mapped_file.h"
#include "common/bundle/place_files.h"
#include "common/mesh/folder_files.h"
#include "common/mesh/obj_files.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

/// Programs read hidden files without being asked, so somebody else's archive places none.
bool is_hidden(const std::string& name) {
  return name.starts_with('.') || name.find("/.") != std::string::npos;
}

/// The entries below the mesh's folder keep their places relative to it. Others have none.
std::vector<FileToPlace> files_around(const Archive& archive, const ArchivedMesh& mesh,
                                      std::vector<std::string>& left_out) {
  std::string folder = folder_of(mesh.path);
  if (!folder.empty()) folder += '/';
  std::vector<FileToPlace> around;
  for (const ArchiveEntry& entry : archive.entries()) {
    if (entry.is_folder() || entry.name == mesh.path) continue;
    if (entry.name.starts_with(folder) && !is_hidden(entry.name)) {
      around.push_back({entry.name, entry.name.substr(folder.size())});
    } else {
      left_out.push_back(entry.name);
    }
  }
  return around;
}

fs::path folder_with(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

Status place_from_archive(const fs::path& zip, const fs::path& copy, MeshFormat format,
                          bool replaces) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(zip));
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(file.bytes(), zip.string()));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  if (mesh.format != format) return Status::ok();
  std::vector<std::string> ignored;
  return place_files(ArchiveFiles(archive), files_around(archive, mesh, ignored), folder_with(copy),
                     replaces);
}

}  // namespace

Result<PlacedMesh> place_mesh(const Archive& archive, const ArchivedMesh& mesh,
                              const fs::path& file, bool replaces) {
  PlacedMesh placed{file, {}};
  const ArchiveFiles from(archive);
  const auto around = files_around(archive, mesh, placed.left_out);
  RETURN_IF_ERROR(place_files(from, around, folder_with(file), replaces));
  const FileToPlace itself = {mesh.path, file.filename().string()};
  RETURN_IF_ERROR(place_files(from, {&itself, 1}, folder_with(file), true));
  return placed;
}

Result<PlacedMesh> place_archive(const Archive& archive, const ArchivedMesh& mesh,
                                 const fs::path& folder, bool replaces) {
  PlacedMesh placed{folder / mesh.path, {}};
  std::vector<FileToPlace> files;
  for (const ArchiveEntry& entry : archive.entries()) {
    if (entry.is_folder()) continue;
    if (is_hidden(entry.name) && entry.name != mesh.path) {
      placed.left_out.push_back(entry.name);
    } else {
      files.push_back({entry.name, entry.name});
    }
  }
  RETURN_IF_ERROR(place_files(ArchiveFiles(archive), files, folder, replaces));
  return placed;
}

Status place_files_of(const fs::path& mesh, const fs::path& copy, bool replaces) {
  ASSIGN_OR_RETURN(const MeshFormat from, mesh_format_of_path(mesh));
  ASSIGN_OR_RETURN(const MeshFormat to, mesh_format_of_path(copy));
  if (from == MeshFormat::kZip && to != from) return place_from_archive(mesh, copy, to, replaces);
  std::error_code ignored;
  const bool is_same_folder = fs::equivalent(folder_with(mesh), folder_with(copy), ignored);
  if (from != MeshFormat::kObj || to != from || is_same_folder) return Status::ok();
  const FolderFiles files(folder_with(mesh));
  ASSIGN_OR_RETURN(const MappedFile obj, MappedFile::open(mesh));
  ASSIGN_OR_RETURN(const ObjFiles named,
                   find_obj_files(obj.bytes(), mesh.filename().string(), files));
  std::vector<FileToPlace> beside;
  for (const std::string& path : named.found) beside.push_back({path, path});
  return place_files(files, beside, folder_with(copy), replaces);
}

}  // namespace burnish
