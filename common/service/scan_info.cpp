#include "common/service/scan_info.h"

#include "common/base/text.h"

namespace burnish {

std::string_view mesh_format_name(MeshFormat format) {
  switch (format) {
    case MeshFormat::kPly:
      return "ply";
    case MeshFormat::kObj:
      return "obj";
    case MeshFormat::kStl:
      return "stl";
    case MeshFormat::kOff:
      return "off";
    case MeshFormat::kGlb:
      return "glb";
    case MeshFormat::kGltf:
      return "gltf";
    case MeshFormat::kZip:
      return "zip";
  }
  return "unknown";
}

Result<MeshFormat> mesh_format_of_name(std::string_view name) {
  for (const auto format : {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kOff,
                            MeshFormat::kGlb, MeshFormat::kGltf, MeshFormat::kZip})
    if (mesh_format_name(format) == name) return format;
  return invalid_argument("mesh format '" + std::string(name) +
                          "' is not one of ply, obj, stl, off, glb, gltf, zip");
}

Status check_unit(std::string_view unit) {
  if (unit.empty()) return Status::ok();
  if (unit.size() > kUnitBytesMax)
    return invalid_argument("the scan's unit has " + std::to_string(unit.size()) +
                            " bytes, the limit is " + std::to_string(kUnitBytesMax));
  return check_name("the scan's unit", unit);
}

}  // namespace burnish
