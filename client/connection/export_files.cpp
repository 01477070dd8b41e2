#include "client/connection/export_files.h"

#include <algorithm>
#include <unistd.h>

#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"
#include "common/bundle/place_mesh.h"
#include "common/transfer/content_hash.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

/// An archive on its way to its files: hidden, and gone with this object.
class HiddenArchive {
 public:
  explicit HiddenArchive(const fs::path& folder)
      : path_(folder / (".burnish-export-" + std::to_string(::getpid()) + ".zip")) {}
  ~HiddenArchive() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  HiddenArchive(const HiddenArchive&) = delete;
  HiddenArchive& operator=(const HiddenArchive&) = delete;
  const fs::path& path() const { return path_; }

 private:
  const fs::path path_;
};

Status take_hash_of_file(const fs::path& path, ExportSummary& summary) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  ContentHash hash;
  hash.update({reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()});
  summary.size_bytes = file.bytes().size();
  summary.sha256 = hash.finish();
  return Status::ok();
}

Result<ExportedFiles> export_file(Connection& connection, const std::string& session,
                                  const ExportWish& wish, const fs::path& path,
                                  const Progress& progress) {
  ASSIGN_OR_RETURN(ExportSummary summary, connection.export_mesh(session, wish, path, progress));
  return ExportedFiles{path, std::move(summary)};
}

Result<PlacedMesh> unpack(const fs::path& path, const ExportTarget& target) {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(path));
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(file.bytes(), "the exported archive"));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  if (target.is_folder) return place_archive(archive, mesh, target.path, target.replaces);
  return place_mesh(archive, mesh, target.path, target.replaces);
}

Status put_in_place(const fs::path& file, const fs::path& target) {
  ASSIGN_OR_RETURN(const MappedFile mapped, MappedFile::open(file));
  return write_file(target,
                    {reinterpret_cast<const char*>(mapped.bytes().data()), mapped.bytes().size()});
}

/// Exports a scan that came in an archive. An older server sends the mesh alone.
Result<ExportedFiles> export_unpacked(Connection& connection, const std::string& session,
                                      const ExportWish& wish, const ExportTarget& target,
                                      const Progress& progress) {
  const HiddenArchive hidden(target.is_folder ? target.path : target.path.parent_path());
  auto exported = export_file(connection, session, wish, hidden.path(), progress);
  if (!exported.is_ok())
    return exported.status().renamed(hidden.path().string(), target.path.string());
  ExportedFiles files = std::move(exported).value();
  if (!target.is_folder && !files.summary.is_archive) {
    files.mesh = target.path;
    RETURN_IF_ERROR(put_in_place(hidden.path(), target.path));
    return files;
  }
  ASSIGN_OR_RETURN(PlacedMesh placed, unpack(hidden.path(), target));
  files.mesh = placed.mesh;
  files.summary.left_out.insert(files.summary.left_out.end(), placed.left_out.begin(),
                                placed.left_out.end());
  RETURN_IF_ERROR(take_hash_of_file(files.mesh, files.summary));
  return files;
}

std::string file_name_of(const ScanInfo& scan) {
  std::string name = scan.name + "." + std::string(mesh_format_name(scan.format));
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

Result<ScanInfo> scan_of(Connection& connection, const std::string& session) {
  ASSIGN_OR_RETURN(const SessionState state, connection.state(session));
  ASSIGN_OR_RETURN(ScanDescription description,
                   connection.describe_scan(state.session.scan_id, state.session.key.depth));
  return std::move(description.scan);
}

}  // namespace

Result<ExportTarget> export_target(const fs::path& path, bool replaces) {
  std::error_code error;
  ExportTarget target{path, !path.has_filename() || fs::is_directory(path, error), MeshFormat::kPly,
                      replaces};
  if (target.is_folder) {
    fs::create_directories(path, error);
    if (error) return errno_status("cannot make the folder " + path.string(), error.value());
    return target;
  }
  ASSIGN_OR_RETURN(target.format, written_format_of_path(path));
  RETURN_IF_ERROR(check_writable(path));
  return target;
}

Result<ExportedFiles> export_files(Connection& connection, const std::string& session,
                                   ExportWish wish, const ExportTarget& target,
                                   const Progress& progress) {
  wish.format = target.format;
  if (target.format == MeshFormat::kZip && !target.is_folder)
    return export_file(connection, session, wish, target.path, progress);
  ASSIGN_OR_RETURN(const ScanInfo scan, scan_of(connection, session));
  if (target.is_folder) wish.format = scan.format;
  wish.with_files = !target.is_folder && scan.format == MeshFormat::kZip;
  if (scan.format == MeshFormat::kZip)
    return export_unpacked(connection, session, wish, target, progress);
  const fs::path file = target.is_folder ? target.path / file_name_of(scan) : target.path;
  return export_file(connection, session, wish, file, progress);
}

}  // namespace burnish
