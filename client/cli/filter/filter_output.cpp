#include "client/cli/filter/filter_output.h"

#include "client/cli/filter/pack_output.h"
#include "client/cli/warn_of_left_out.h"
#include "common/base/atomic_file.h"
#include "common/bundle/place_mesh.h"
#include "common/bundle/scan_bundle.h"
#include "common/mesh/rewrite/left_out.h"
#include "common/mesh/rewrite/rewrite.h"

namespace burnish {

/// A .gltf whose positions lie in another file is written again in an archive only.
static Status check_buffers(const FilterPaths& paths, MeshFormat in, MeshFormat out) {
  if (in != MeshFormat::kGltf || out != MeshFormat::kGltf) return Status::ok();
  ASSIGN_OR_RETURN(const ScanBundle bundle, ScanBundle::open(paths.in));
  if (bundle.beside().empty()) return Status::ok();
  return invalid_argument(paths.in.string() + " names " + bundle.beside()[0] +
                          " beside it; write a .zip archive, or another format");
}

Result<FilterFormats> check_filter_paths(const FilterOptions& options, const FilterPaths& paths) {
  FilterFormats formats{};
  ASSIGN_OR_RETURN(formats.in, mesh_format_of_path(paths.in));
  ASSIGN_OR_RETURN(formats.out, written_format_of_path(paths.out));
  if (formats.out != formats.in && !formats.packs() && !is_written_for_any_scan(formats.out))
    return invalid_argument(paths.out_name + ": only a file of the same format is written as " +
                            paths.out.extension().string() +
                            "; use .ply, .obj, .stl, .glb or .zip");
  RETURN_IF_ERROR(check_buffers(paths, formats.in, formats.out));
  std::error_code ignored;
  if (!options.force && std::filesystem::equivalent(paths.in, paths.out, ignored))
    return invalid_argument(paths.out_name + " is the file to read; --force replaces it");
  RETURN_IF_ERROR(check_writable(paths.out));
  return formats;
}

Result<std::vector<std::string>> tell_left_out(const FilterPaths& paths, FilterFormats formats,
                                               const TriangleMesh& mesh) {
  if (formats.packs()) return std::vector<std::string>();
  const OriginalFile original = {paths.in, formats.in, paths.in.string()};
  ASSIGN_OR_RETURN(auto left_out, attributes_left_out(original, formats.out, mesh));
  warn_of_left_out(left_out, paths.out_name);
  return left_out;
}

Status write_surface(const FilterOptions& options, const FilterPaths& paths, FilterFormats formats,
                     const MovedMesh& moved) {
  if (formats.packs()) return write_packed_mesh(paths.in, moved, paths.out);
  RETURN_IF_ERROR(write_moved_mesh({paths.in, formats.in, paths.in.string()}, moved, paths.out));
  return place_files_of(paths.in, paths.out, options.force);
}

}  // namespace burnish
