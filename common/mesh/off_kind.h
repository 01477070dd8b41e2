#pragma once

#include <optional>
#include <string_view>

namespace burnish {

/// The attributes that an OFF file's vertices have after x y z: normals, colours, then texture
/// coordinates.
struct OffKind {
  bool has_normals = false;
  bool has_colours = false;
  bool has_texture_coordinates = false;
};

/// Parses the first word of a file: OFF with any of ST, C and N before it.
inline std::optional<OffKind> parse_off_kind(std::string_view magic) {
  OffKind kind;
  kind.has_texture_coordinates = magic.starts_with("ST");
  if (kind.has_texture_coordinates) magic.remove_prefix(2);
  kind.has_colours = magic.starts_with('C');
  if (kind.has_colours) magic.remove_prefix(1);
  kind.has_normals = magic.starts_with('N');
  if (kind.has_normals) magic.remove_prefix(1);
  if (magic != "OFF") return std::nullopt;
  return kind;
}

}  // namespace burnish
