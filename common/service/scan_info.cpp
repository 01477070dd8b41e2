#include "common/service/scan_info.h"

#include <algorithm>

namespace burnish {

Status check_name(std::string_view what, std::string_view name) {
  const std::string subject(what);
  if (name.empty()) return invalid_argument(subject + " is empty");
  if (name.size() > kNameBytesMax)
    return invalid_argument(subject + " has " + std::to_string(name.size()) +
                            " bytes, the limit is " + std::to_string(kNameBytesMax));
  const bool printable = std::all_of(name.begin(), name.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
  });
  if (!printable) return invalid_argument(subject + " has control characters");
  return Status::ok();
}

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
  return invalid_argument("mesh format '" + std::string(name) + "' is none of ply, obj, stl, off");
}

}  // namespace burnish
