#include "common/bundle/place_mesh.h"

#include <algorithm>
#include <utility>

#include "common/base/mapped_file.h"
#include "common/bundle/place_files.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/io/named_files.h"

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

/// The files that go beside a rewritten copy of a mesh.
struct FilesOfMesh {
  const FilesBeside& from;
  const std::string& mesh;  ///< its path among them
  std::vector<FileToPlace> files;
  bool are_there = false;  ///< the copy lies in their folder
};

/// Calls `use` with the files of the archive if its mesh has this format.
template <typename Use>
Status with_files_of_archive(const fs::path& zip, MeshFormat format, const Use& use) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(zip));
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(file.bytes(), zip.string()));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  if (mesh.format != format) return Status::ok();
  std::vector<std::string> ignored;
  const ArchiveFiles from(archive);
  return use(FilesOfMesh{from, mesh.path, files_around(archive, mesh, ignored)});
}

bool is_same_folder(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return fs::equivalent(folder_with(one), folder_with(other), ignored);
}

/// Calls `use` with the files that the mesh names.
template <typename Use>
Status with_named_files(const fs::path& path, const fs::path& copy, MeshFormat format,
                        const Use& use) {
  const FolderFiles folder(folder_with(path));
  const std::string mesh = path.filename().string();
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  ASSIGN_OR_RETURN(const NamedFiles named, find_named_files(file.bytes(), format, {&folder, mesh}));
  std::vector<FileToPlace> beside;
  for (const std::string& found : named.found) beside.push_back({found, found});
  return use(FilesOfMesh{folder, mesh, std::move(beside), is_same_folder(path, copy)});
}

template <typename Use>
Status with_files_of(const fs::path& mesh, const fs::path& copy, const Use& use) {
  ASSIGN_OR_RETURN(const MeshFormat from, mesh_format_of_path(mesh));
  ASSIGN_OR_RETURN(const MeshFormat to, mesh_format_of_path(copy));
  if (from == MeshFormat::kZip && to != from) return with_files_of_archive(mesh, to, use);
  if (from != to || from == MeshFormat::kZip) return Status::ok();
  return with_named_files(mesh, copy, from, use);
}

/// Takes the files out that will have new bytes. Fails: already_exists if one is there.
Status check_buffers(FilesOfMesh& beside, std::span<const std::string> buffers,
                     const fs::path& folder) {
  for (const std::string& name : buffers) {
    const auto path = beside.from.find(folder_of(beside.mesh), name);
    const auto file = std::ranges::find(beside.files, path.value_or(""), &FileToPlace::source);
    if (file == beside.files.end()) continue;
    std::error_code ignored;
    const fs::path target = folder / file->target;
    if (fs::exists(target, ignored))
      return already_exists(target.string() +
                            " is there, and the new mesh needs its own; write it into another "
                            "folder, a .zip, or another format. --force replaces the file");
    beside.files.erase(file);
  }
  return Status::ok();
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

Status check_places_of(const fs::path& mesh, const fs::path& copy,
                       std::span<const std::string> buffers) {
  return with_files_of(mesh, copy, [&](FilesOfMesh beside) -> Status {
    RETURN_IF_ERROR(check_buffers(beside, buffers, folder_with(copy)));
    if (beside.are_there) return Status::ok();
    return check_places(beside.from, beside.files, folder_with(copy));
  });
}

Status place_files_of(const fs::path& mesh, const fs::path& copy, bool replaces) {
  return with_files_of(mesh, copy, [&](const FilesOfMesh& beside) -> Status {
    if (beside.are_there) return Status::ok();
    return place_files(beside.from, beside.files, folder_with(copy), replaces);
  });
}

}  // namespace burnish
