#include "common/mesh/rewrite/left_out/left_out.h"

#include <algorithm>

#include "common/base/mapped_file.h"
#include "common/mesh/off/off_text.h"
#include "common/mesh/ply/ply_header.h"
#include "common/mesh/ply/ply_layout.h"
#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/left_out/left_out_list.h"
#include "common/mesh/rewrite/packed_mesh.h"
#include "common/mesh/rewrite/write_plan.h"
#include "common/mesh/stl/stl_layout.h"

namespace burnish {

static bool list_off_extras(std::span<const uint8_t> bytes, size_t triangles,
                            const FileSteps& steps, LeftOutList& list) {
  OffText text(bytes, "", steps);
  if (!text.read_header().is_ok()) return false;
  list.add_if(text.kind().has_normals, "normals");
  list.add_if(text.kind().has_texture_coordinates, "texture coordinates");
  list.add_if(text.faces() < triangles, "polygons");
  return true;
}

/// Some programs keep a facet's colour in its two last bytes.
static bool list_stl_extras(std::span<const uint8_t> bytes, size_t triangles, FileSteps steps,
                            LeftOutList& list) {
  if (is_stl_text(bytes)) return true;
  if (bytes.size() < kStlHeaderBytes + triangles * kStlFacetBytes) return false;
  for (size_t facet = 1; facet <= triangles; ++facet) {
    steps.take();
    const uint8_t* end = bytes.data() + kStlHeaderBytes + facet * kStlFacetBytes;
    list.add_if(end[-1] != 0 || end[-2] != 0, "attributes of facets");
  }
  return true;
}

static bool list_extras(std::span<const uint8_t> bytes, MeshFormat format, size_t triangles,
                        const FileSteps& steps, LeftOutList& list) {
  switch (format) {
    case MeshFormat::kPly:
      return list_ply_extras(bytes, triangles, list);
    case MeshFormat::kObj:
      return list_obj_extras(bytes, triangles, steps, list);
    case MeshFormat::kStl:
      return list_stl_extras(bytes, triangles, steps, list);
    case MeshFormat::kOff:
      return list_off_extras(bytes, triangles, steps, list);
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return list_gltf_extras(bytes, list);
    case MeshFormat::kZip:
      return false;
  }
  return false;
}

static Status list_packed_extras(std::span<const uint8_t> bytes, const std::string& name,
                                 MeshFormat to, size_t triangles, const FileBudget& budget,
                                 LeftOutList& list) {
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(bytes, name, budget));
  list_files_beside(packed, list);
  if (to == packed.mesh.format ||
      list_extras(packed.bytes, packed.mesh.format, triangles, FileSteps(budget), list))
    return Status::ok();
  return changed_original(packed.name, "its beginning is another format's");
}

Result<std::vector<std::string>> attributes_left_out(const OriginalFile& original, MeshFormat to,
                                                     const MeshView& mesh,
                                                     const FileBudget& budget) try {
  LeftOutList list;
  if (to == original.format || to == MeshFormat::kZip) return list.names();
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(original.path));
  const size_t triangles = mesh.triangles.size();
  if (original.format == MeshFormat::kZip) {
    RETURN_IF_ERROR(list_packed_extras(file.bytes(), original.name, to, triangles, budget, list));
  } else if (!list_extras(file.bytes(), original.format, triangles, FileSteps(budget), list)) {
    return changed_original(original.name, "its beginning is another format's");
  }
  const bool is_transparent = std::any_of(mesh.colours.begin(), mesh.colours.end(),
                                          [](const Rgba8& c) { return c[3] != 255; });
  list.add_if(to == MeshFormat::kStl && mesh.has_colours(), "colours");
  list.add_if(to == MeshFormat::kObj && is_transparent, "transparency");
  return list.names();
} catch (const WorkCancelled&) {
  return cancelled("reading the original was cancelled");
}

static bool has_ply_colours(std::span<const uint8_t> bytes) {
  const auto header = parse_ply_header(bytes, "");
  if (!header.is_ok()) return false;
  const auto layout = find_ply_layout(*header, "");
  return layout.is_ok() && layout->has_colours;
}

static bool rewrites_colours(std::span<const uint8_t> bytes, MeshFormat format,
                             const FileBudget& budget) {
  if (format == MeshFormat::kObj) return obj_colour_scale(bytes, FileSteps(budget)).has_value();
  if (format == MeshFormat::kPly) return has_ply_colours(bytes);
  return format == MeshFormat::kOff;
}

Result<bool> keeps_changed_colours(const OriginalFile& original, MeshFormat to,
                                   const FileBudget& budget) try {
  if (to == MeshFormat::kStl) return false;
  ASSIGN_OR_RETURN(const WritePlan plan, plan_to_write(original, to));
  if (plan.way == WriteWay::kConvert) return true;
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(original.path));
  if (original.format != MeshFormat::kZip)
    return rewrites_colours(file.bytes(), original.format, budget);
  ASSIGN_OR_RETURN(const PackedMesh packed, PackedMesh::open(file.bytes(), original.name, budget));
  return rewrites_colours(packed.bytes, packed.mesh.format, budget);
} catch (const WorkCancelled&) {
  return cancelled("reading the original was cancelled");
}

static const std::string kColoursOf = "edited colours of ";

bool is_lost_in_any_format(std::string_view name) {
  return name.starts_with(kColoursOf);
}

Result<std::vector<std::string>> edited_colours_left_out(const OriginalFile& original,
                                                         MeshFormat to, const SeamWish& seams,
                                                         const PictureReport& pictures,
                                                         const FileBudget& budget) {
  std::vector<std::string> names;
  for (const std::string& kept : pictures.kept) names.push_back(kColoursOf + kept);
  ASSIGN_OR_RETURN(const bool is_kept, keeps_changed_colours(original, to, budget));
  const bool has_pictures = pictures.pictures > 0 || pictures.seams;
  if (!is_kept && !has_pictures) names.emplace_back("edited colours");
  if (!is_kept && has_pictures && pictures.bare_triangles > 0)
    names.push_back(kColoursOf + std::to_string(pictures.bare_triangles) +
                    (pictures.bare_triangles == 1 ? " triangle" : " triangles") +
                    " without a picture");
  if (seams.is_on() && !pictures.seams) names.emplace_back("levelled seams");
  return names;
}

}  // namespace burnish
