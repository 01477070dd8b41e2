#include "client/cli/filter/filter_output.h"

#include "client/cli/filter/filter_jobs.h"
#include "client/cli/filter/pack_output.h"
#include "client/cli/warn_of_left_out.h"
#include "common/base/atomic_file.h"
#include "common/base/mapped_file.h"
#include "common/bundle/place_mesh.h"
#include "common/mesh/files/folder_files.h"
#include "common/mesh/io/textured_surface.h"
#include "common/mesh/rewrite/left_out/left_out.h"
#include "common/mesh/rewrite/rewrite.h"
#include "common/mesh/textures/shown_picture.h"

namespace burnish {

static std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

static OriginalFile original_of(const FilterPaths& paths, MeshFormat format) {
  return {paths.in, format, paths.in.string()};
}

/// Checks the files that OUT needs beside it.
static Status check_beside(const FilterOptions& options, const FilterPaths& paths,
                           const WritePlan& plan) {
  if (paths.out_name == kStandardStream) return check_one_file(plan);
  if (options.force) return Status::ok();
  return check_places_of(paths.in, paths.out, plan.buffers);
}

Result<FilterFormats> check_filter_paths(const FilterOptions& options, const FilterPaths& paths) {
  FilterFormats formats{};
  ASSIGN_OR_RETURN(formats.in, mesh_format_of_path(paths.in));
  ASSIGN_OR_RETURN(formats.out, written_format_of_path(paths.out));
  ASSIGN_OR_RETURN(formats.plan, plan_to_write(original_of(paths, formats.in), formats.out));
  std::error_code ignored;
  if (!options.force && std::filesystem::equivalent(paths.in, paths.out, ignored))
    return invalid_argument(paths.out_name + " is the file to read; --force replaces it");
  RETURN_IF_ERROR(check_writable(paths.out));
  RETURN_IF_ERROR(check_beside(options, paths, formats.plan));
  return formats;
}

Status check_has_pictures(const FilterPaths& paths, MeshFormat format) {
  const Status none =
      failed_precondition(paths.in.string() + " has no pictures whose seams could be levelled");
  if (format == MeshFormat::kStl || format == MeshFormat::kOff) return none;
  const FolderFiles folder(folder_of(paths.in));
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(paths.in));
  const auto take = [&](const TexturedSurface& surface) {
    for (uint32_t t = 0; t < surface.textures.triangles.size(); ++t)
      if (shown_picture(surface.textures, t) != kNoTexture) return Status::ok();
    return none;
  };
  MeshSurroundings beside;
  if (format != MeshFormat::kZip) beside = {&folder, paths.in.filename().string(), {}};
  return read_textured_surface(file.bytes(), format, paths.in.string(), take, beside);
}

Result<std::vector<std::string>> tell_left_out(const FilterPaths& paths, FilterFormats formats,
                                               const TriangleMesh& mesh) {
  ASSIGN_OR_RETURN(auto left_out,
                   attributes_left_out(original_of(paths, formats.in), formats.out, mesh));
  warn_of_left_out(left_out, paths.out_name);
  return left_out;
}

/// Returns whether pictures beside the mesh are to change.
static bool changes_pictures_beside(const FilterOptions& options, const FilterPaths& paths,
                                    const FilterFormats& formats, const MovedMesh& moved) {
  const bool is_one_mesh =
      formats.plan.way == WriteWay::kUnpack ||
      (formats.plan.way == WriteWay::kRewrite && formats.out != MeshFormat::kZip);
  if (!is_one_mesh || paths.out_name == kStandardStream || !moved.colours().is_there())
    return false;
  std::error_code ignored;
  return options.force || formats.plan.way == WriteWay::kUnpack ||
         !std::filesystem::equivalent(folder_of(paths.in), folder_of(paths.out), ignored);
}

Status write_surface(const FilterOptions& options, const FilterPaths& paths, FilterFormats formats,
                     const MovedMesh& moved, PictureWork& pictures) {
  const OriginalFile original = original_of(paths, formats.in);
  if (formats.packs()) return write_packed_mesh(paths.in, moved, paths.out, pictures);
  if (!formats.plan.buffers.empty() || changes_pictures_beside(options, paths, formats, moved))
    return write_spread_mesh(original, moved, paths.out, options.force, pictures);
  RETURN_IF_ERROR(place_files_of(paths.in, paths.out, options.force));
  return write_moved_mesh(original, moved, paths.out, &pictures);
}

Result<std::vector<std::string>> tell_colours_left_out(const FilterPaths& paths,
                                                       FilterFormats formats, const SeamWish& seams,
                                                       const PictureReport& pictures) {
  ASSIGN_OR_RETURN(auto left_out, edited_colours_left_out(original_of(paths, formats.in),
                                                          formats.out, seams, pictures));
  warn_of_left_out(left_out, paths.out_name);
  return left_out;
}

}  // namespace burnish
