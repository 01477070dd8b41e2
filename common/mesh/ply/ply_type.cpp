#include "common/mesh/ply/ply_type.h"

#include <algorithm>
#include <array>

namespace burnish {

namespace {

struct TypeName {
  std::string_view old_name;
  std::string_view new_name;
  PlyType type;
};

constexpr std::array<TypeName, 8> kTypeNames = {{{"char", "int8", PlyType::kInt8},
                                                 {"uchar", "uint8", PlyType::kUint8},
                                                 {"short", "int16", PlyType::kInt16},
                                                 {"ushort", "uint16", PlyType::kUint16},
                                                 {"int", "int32", PlyType::kInt32},
                                                 {"uint", "uint32", PlyType::kUint32},
                                                 {"float", "float32", PlyType::kFloat32},
                                                 {"double", "float64", PlyType::kFloat64}}};

}  // namespace

std::optional<PlyType> ply_type_of_name(std::string_view name) {
  const auto known = std::find_if(kTypeNames.begin(), kTypeNames.end(), [&](const TypeName& t) {
    return t.old_name == name || t.new_name == name;
  });
  if (known == kTypeNames.end()) return std::nullopt;
  return known->type;
}

size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kInt32:
    case PlyType::kUint32:
    case PlyType::kFloat32:
      return 4;
    case PlyType::kFloat64:
      return 8;
  }
  return 0;
}

bool is_integer(PlyType type) {
  return type != PlyType::kFloat32 && type != PlyType::kFloat64;
}

bool exceeds_float(PlyType type) {
  return type == PlyType::kFloat64 || type == PlyType::kInt32 || type == PlyType::kUint32;
}

}  // namespace burnish
