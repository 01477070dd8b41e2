#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace burnish {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// By its old or its new name, e.g. "uchar" or "uint8".
std::optional<PlyType> ply_type_of_name(std::string_view name);

size_t bytes_of(PlyType type);
bool is_integer(PlyType type);

/// Whether the type holds values that a float does not.
bool exceeds_float(PlyType type);

}  // namespace burnish
