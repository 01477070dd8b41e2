#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"
#include "common/mesh/ply/ply_type.h"

namespace burnish {

/// "property float x", or "property list uchar int vertex_indices" with a count before the values.
struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;

  const PlyProperty* find(std::string_view property_name) const;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

/// The content of a PLY file's header.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  size_t body_offset = 0;  ///< bytes
  size_t lines = 0;        ///< lines of the header

  const PlyElement* find(std::string_view element_name) const;
};

/// Parses the header and checks that a body of the promised size can follow.
/// Fails: invalid_argument that names the line, or the first element that cannot be complete.
Result<PlyHeader> parse_ply_header(std::span<const uint8_t> bytes, const std::string& name);

}  // namespace burnish
