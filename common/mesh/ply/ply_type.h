#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace burnish {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Returns the type of an old or a new name, e.g. "uchar" or "uint8".
std::optional<PlyType> ply_type_of_name(std::string_view name);

size_t bytes_of(PlyType type);
bool is_integer(PlyType type);

/// Returns whether the type holds values that a float cannot hold.
bool exceeds_float(PlyType type);

}  // namespace burnish
