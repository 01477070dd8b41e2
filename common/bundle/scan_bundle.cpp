#include "common/bundle/scan_bundle.h"

#include <algorithm>

#include "common/archive/archive_writer.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/io/named_files.h"

namespace burnish {

namespace fs = std::filesystem;

Result<fs::path> mesh_file_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  std::vector<fs::path> meshes;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    const bool is_hidden = entry.path().filename().string().starts_with('.');
    if (!is_hidden && entry.is_regular_file() && mesh_format_of_path(entry.path()).is_ok())
      meshes.push_back(entry.path());
  }
  if (error) return errno_status("cannot list " + path.string(), error.value());
  if (meshes.size() == 1) return meshes[0];
  std::sort(meshes.begin(), meshes.end());
  if (meshes.empty())
    return invalid_argument(path.string() + ": the folder has no mesh file; it must have 1");
  return invalid_argument(path.string() + ": the folder has " + std::to_string(meshes.size()) +
                          " mesh files, " + meshes[0].filename().string() + " and " +
                          meshes[1].filename().string() + " among them; name one");
}

Result<ScanBundle> ScanBundle::open(const fs::path& path, bool alone) {
  ScanBundle bundle;
  ASSIGN_OR_RETURN(bundle.mesh_, mesh_file_of(path));
  ASSIGN_OR_RETURN(bundle.format_, mesh_format_of_path(bundle.mesh_));
  ASSIGN_OR_RETURN(bundle.file_, MappedFile::open(bundle.mesh_));
  if (alone) return bundle;
  RETURN_IF_ERROR(bundle.gather().with_context(bundle.mesh_.string()));
  if (!bundle.beside_.empty())
    RETURN_IF_ERROR(bundle.pack().with_context("packing " + bundle.mesh_.string()));
  return bundle;
}

Status ScanBundle::gather() {
  const FolderFiles folder(mesh_.parent_path());
  ASSIGN_OR_RETURN(const NamedFiles files,
                   find_named_files(file_->bytes(), format_, {&folder, mesh_.filename().string()}));
  beside_ = files.found;
  missing_ = files.missing;
  return Status::ok();
}

Status ScanBundle::pack() {
  std::vector<MappedFile> opened;
  std::vector<FileToPack> files = {{mesh_.filename().string(), file_->bytes()}};
  for (const std::string& path : beside_) {
    ASSIGN_OR_RETURN(MappedFile file, MappedFile::open(mesh_.parent_path() / path));
    opened.push_back(std::move(file));
    files.push_back({path, opened.back().bytes()});
  }
  ASSIGN_OR_RETURN(packed_, pack_archive(files));
  file_.reset();
  format_ = MeshFormat::kZip;
  return Status::ok();
}

}  // namespace burnish
