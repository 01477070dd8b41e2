#include "common/mesh/mesh_format.h"

#include <algorithm>
#include <cctype>

namespace burnish {

std::string_view mesh_format_name(MeshFormat format) {
  for (const auto& [known, name] : kMeshFormats)
    if (known == format) return name;
  return "unknown";
}

Result<MeshFormat> mesh_format_of_name(std::string_view name) {
  std::string names;
  for (const auto& [format, known] : kMeshFormats) {
    if (known == name) return format;
    names.append(names.empty() ? "" : ", ").append(known);
  }
  return invalid_argument("mesh format '" + std::string(name) + "' is not one of " + names);
}

std::vector<std::string> mesh_format_names() {
  std::vector<std::string> names;
  for (const auto& [format, name] : kMeshFormats) names.emplace_back(name);
  return names;
}

std::string extension_of(MeshFormat format) {
  return "." + std::string(mesh_format_name(format));
}

std::vector<std::string> mesh_extensions() {
  std::vector<std::string> extensions;
  for (const auto& [format, name] : kMeshFormats) extensions.push_back(extension_of(format));
  return extensions;
}

std::string extensions_text(bool (*is_one)(MeshFormat)) {
  std::string text, last;
  for (const auto& [format, name] : kMeshFormats) {
    if (!is_one(format)) continue;
    if (!last.empty()) text.append(text.empty() ? "" : ", ").append(last);
    last = extension_of(format);
  }
  return text.empty() ? last : text + " or " + last;
}

/// Fails: invalid_argument that ends with the refusal.
static Result<MeshFormat> format_of(const std::filesystem::path& path, const std::string& refusal) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [format, name] : kMeshFormats)
    if (extension == extension_of(format)) return format;
  return invalid_argument(path.string() + ": extension '" + path.extension().string() +
                          "' is not a mesh format" + refusal);
}

Result<MeshFormat> mesh_format_of_path(const std::filesystem::path& path) {
  return format_of(path, "; use " + extensions_text());
}

Result<MeshFormat> written_format_of_path(const std::filesystem::path& path) {
  return format_of(path, " that Burnish writes; use " + extensions_text([](MeshFormat format) {
                           return format == MeshFormat::kZip || is_written_for_any_scan(format);
                         }));
}

}  // namespace burnish
