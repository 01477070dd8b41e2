#include "client/cli/filter/pack_output.h"

#include <iostream>
#include <string_view>
#include <vector>

#include "common/archive/archive.h"
#include "common/archive/archive_writer.h"
#include "common/base/atomic_file.h"
#include "common/base/text.h"
#include "common/bundle/place_mesh.h"
#include "common/bundle/scan_bundle.h"
#include "common/mesh/files/archive_files.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

/// Returns the archive with the mesh as it was.
static Result<std::vector<uint8_t>> pack_original(const ScanBundle& bundle) {
  if (bundle.format() == MeshFormat::kZip)
    return std::vector<uint8_t>(bundle.bytes().begin(), bundle.bytes().end());
  const FileToPack mesh = {bundle.mesh().filename().string(), bundle.bytes()};
  return pack_archive({&mesh, 1});
}

Status write_packed_mesh(const std::filesystem::path& original, const MovedMesh& moved,
                         const std::filesystem::path& archive, PictureWork& pictures) {
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(original));
  if (!bundle.missing().empty())
    std::cerr << "warning: " << missing_text(original.string(), bundle.missing()) << "\n";
  ASSIGN_OR_RETURN(const std::vector<uint8_t> packed, pack_original(bundle));
  ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::create(archive));
  OutputBuffer output(file);
  RETURN_IF_ERROR(
      rewrite_mesh(packed, MeshFormat::kZip, original.string(), moved, output, &pictures));
  return file.commit();
}

Status write_spread_mesh(const OriginalFile& original, const MovedMesh& moved,
                         const std::filesystem::path& copy, bool replaces, PictureWork& pictures) {
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(original.path));
  if (bundle.format() != MeshFormat::kZip)
    return write_moved_mesh(original, moved, copy, &pictures);
  std::vector<uint8_t> after;
  OutputBuffer output([&](std::string_view piece) {
    after.insert(after.end(), piece.begin(), piece.end());
    return Status::ok();
  });
  RETURN_IF_ERROR(
      rewrite_mesh(bundle.bytes(), bundle.format(), original.name, moved, output, &pictures));
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(after, original.name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  return place_mesh(archive, mesh, copy, replaces).status();
}

}  // namespace burnish
