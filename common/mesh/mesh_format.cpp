#include "common/mesh/mesh_format.h"

#include <algorithm>
#include <cctype>

namespace burnish {

std::string_view mesh_format_name(MeshFormat format) {
  for (const MeshFormatFacts& known : kMeshFormats)
    if (known.format == format) return known.name;
  return "unknown";
}

Result<MeshFormat> mesh_format_of_name(std::string_view name) {
  std::string names;
  for (const MeshFormatFacts& known : kMeshFormats) {
    if (known.name == name) return known.format;
    names.append(names.empty() ? "" : ", ").append(known.name);
  }
  return invalid_argument("mesh format '" + std::string(name) + "' is not one of " + names);
}

std::vector<std::string> mesh_format_names() {
  std::vector<std::string> names;
  for (const MeshFormatFacts& known : kMeshFormats) names.emplace_back(known.name);
  return names;
}

std::string extension_of(MeshFormat format) {
  return "." + std::string(mesh_format_name(format));
}

std::vector<std::string> mesh_extensions() {
  std::vector<std::string> extensions;
  for (const MeshFormatFacts& known : kMeshFormats)
    extensions.push_back(extension_of(known.format));
  return extensions;
}

std::string extensions_text(bool (*is_one)(const MeshFormatFacts&)) {
  std::string text, last;
  for (const MeshFormatFacts& known : kMeshFormats) {
    if (!is_one(known)) continue;
    if (!last.empty()) text.append(text.empty() ? "" : ", ").append(last);
    last = extension_of(known.format);
  }
  return text.empty() ? last : text + " or " + last;
}

bool is_written_for_any_scan(MeshFormat format) {
  for (const MeshFormatFacts& known : kMeshFormats)
    if (known.format == format) return known.is_written_for_any_scan;
  return false;
}

/// Fails: invalid_argument that ends with the refusal.
static Result<MeshFormat> format_of(const std::filesystem::path& path, const std::string& refusal) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const MeshFormatFacts& known : kMeshFormats)
    if (extension == extension_of(known.format)) return known.format;
  return invalid_argument(path.string() + ": extension '" + path.extension().string() +
                          "' is not a mesh format" + refusal);
}

Result<MeshFormat> mesh_format_of_path(const std::filesystem::path& path) {
  return format_of(path, "; use " + extensions_text());
}

Result<MeshFormat> written_format_of_path(const std::filesystem::path& path) {
  const auto is_written = [](const MeshFormatFacts& known) {
    return known.is_written_for_any_scan || known.format == MeshFormat::kZip;
  };
  return format_of(path, " that Burnish writes; use " + extensions_text(is_written));
}

}  // namespace burnish
