#include "common/service/scan_info.h"

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
  }
  return "unknown";
}

Result<MeshFormat> mesh_format_of_name(std::string_view name) {
  for (const auto format : {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kStl, MeshFormat::kOff})
    if (mesh_format_name(format) == name) return format;
  return invalid_argument("mesh format '" + std::string(name) +
                          "' is not one of ply, obj, stl, off");
}

}  // namespace burnish
