#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The mesh formats, with the numbers that the protocol has. kZip is a mesh file with the files
/// beside it, packed as one archive.
enum class MeshFormat { kPly = 1, kObj = 2, kStl = 3, kOff = 4, kGlb = 5, kZip = 6, kGltf = 7 };

/// The facts of a mesh format that messages and dialogues need.
struct MeshFormatFacts {
  MeshFormat format;
  std::string_view name;         ///< a file's extension without the dot; the word in records
  bool is_written_for_any_scan;  ///< else for scans that came in it: rewrite/rewrite.h
};

/// All formats in the order in which people read them.
inline constexpr std::array<MeshFormatFacts, 7> kMeshFormats = {{
    {MeshFormat::kPly, "ply", true},
    {MeshFormat::kObj, "obj", true},
    {MeshFormat::kStl, "stl", true},
    {MeshFormat::kOff, "off", false},
    {MeshFormat::kGlb, "glb", true},
    {MeshFormat::kGltf, "gltf", false},
    {MeshFormat::kZip, "zip", false},
}};

inline bool is_gltf(MeshFormat format) {
  return format == MeshFormat::kGlb || format == MeshFormat::kGltf;
}

/// Returns the name of a format: "ply".
std::string_view mesh_format_name(MeshFormat format);

/// Returns the format of a name. Fails: invalid_argument that names the choices.
Result<MeshFormat> mesh_format_of_name(std::string_view name);

/// Returns the names of all formats.
std::vector<std::string> mesh_format_names();

/// Returns the extension of a format's files: ".ply".
std::string extension_of(MeshFormat format);

/// Returns the extensions of all formats.
std::vector<std::string> mesh_extensions();

/// Returns some formats as a choice: ".ply, .obj or .stl".
std::string extensions_text(bool (*is_one)(const MeshFormatFacts&) = [](const MeshFormatFacts&) {
  return true;
});

/// Returns whether write_mesh() writes the format for any scan.
bool is_written_for_any_scan(MeshFormat format);

/// Returns the format by file extension, in any case. Fails: invalid_argument that names the path
/// and the choices.
Result<MeshFormat> mesh_format_of_path(const std::filesystem::path& path);

/// Does the same for a file to write, in other words. Some formats need a scan that came in them.
Result<MeshFormat> written_format_of_path(const std::filesystem::path& path);

}  // namespace burnish
