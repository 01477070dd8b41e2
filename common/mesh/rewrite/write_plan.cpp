#include "common/mesh/rewrite/write_plan.h"

#include <span>
#include <utility>

#include "common/base/mapped_file.h"
#include "common/mesh/files/archive_files.h"
#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

Result<WriteWay> find_way(MeshFormat file, MeshFormat mesh, MeshFormat to,
                          const std::string& name) {
  if (to == file) return WriteWay::kRewrite;
  if (to == MeshFormat::kZip) return WriteWay::kPack;
  if (to == mesh) return WriteWay::kUnpack;
  if (is_written_for_any_scan(to)) return WriteWay::kConvert;
  const std::string wish = extension_of(to);
  return invalid_argument(name + (file == MeshFormat::kZip ? " has a " : " is a ") +
                          extension_of(mesh) + " file: only a scan from a " + wish +
                          " file is written as " + wish + "; use .ply, .obj, .stl, .glb or .zip");
}

static Status take_buffers(std::span<const uint8_t> gltf, WritePlan& plan) {
  ASSIGN_OR_RETURN(GltfNames names, names_in_gltf(gltf));
  plan.buffers = std::move(names.buffers);
  return Status::ok();
}

static Status plan_from_archive(std::span<const uint8_t> bytes, MeshFormat to, WritePlan& plan) {
  ASSIGN_OR_RETURN(const Archive archive, Archive::open(bytes, plan.name));
  ASSIGN_OR_RETURN(const ArchivedMesh mesh, find_mesh(archive));
  ASSIGN_OR_RETURN(plan.way, find_way(MeshFormat::kZip, mesh.format, to, plan.name));
  if (plan.way != WriteWay::kUnpack || !is_gltf(to)) return Status::ok();
  ASSIGN_OR_RETURN(const auto content, archive.read(mesh.entry));
  return take_buffers(content, plan).with_context(plan.name);
}

Result<WritePlan> plan_to_write(const OriginalFile& original, MeshFormat to) {
  WritePlan plan{WriteWay::kRewrite, original.name, {}};
  const bool is_packed = original.format == MeshFormat::kZip;
  if (is_packed && to == MeshFormat::kZip) return plan;
  if (!is_packed) {
    ASSIGN_OR_RETURN(plan.way, find_way(original.format, original.format, to, plan.name));
    if (plan.way != WriteWay::kRewrite || !is_gltf(to)) return plan;
  }
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(original.path));
  RETURN_IF_ERROR(is_packed ? plan_from_archive(file.bytes(), to, plan)
                            : take_buffers(file.bytes(), plan).with_context(plan.name));
  return plan;
}

Status check_one_file(const WritePlan& plan) {
  if (plan.buffers.empty()) return Status::ok();
  return invalid_argument(
      plan.name + " has its data in '" + plan.buffers[0] +
      "' beside it, which one file cannot have; write a .zip, or another format");
}

}  // namespace burnish
