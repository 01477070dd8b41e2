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

/// Takes the first word of a file, OFF with any of ST, C and N before it, from the beginning of
/// `text`.
inline std::optional<OffKind> take_off_kind(std::string_view& text) {
  const auto take = [](std::string_view& rest, std::string_view word) {
    const bool is_there = rest.starts_with(word);
    if (is_there) rest.remove_prefix(word.size());
    return is_there;
  };
  std::string_view rest = text;
  OffKind kind;
  kind.has_texture_coordinates = take(rest, "ST");
  kind.has_colours = take(rest, "C");
  kind.has_normals = take(rest, "N");
  if (!take(rest, "OFF")) return std::nullopt;
  text = rest;
  return kind;
}

}  // namespace burnish
