#include "common/mesh/obj_colours.h"

#include <algorithm>
#include <map>

#include "common/mesh/obj_files.h"
#include "common/mesh/obj_texture_uses.h"
#include "common/picture/picture.h"

namespace burnish {

namespace {

constexpr Rgba8 kWhite = {255, 255, 255, 255};

/// Puts the materials' colours onto the vertices.
class ObjPainter {
 public:
  ObjPainter(const std::vector<Material>& materials, TextureUses uses)
      : materials_(materials), uses_(std::move(uses)), colours_(uses_.material_of.size(), kWhite) {}

  void paint_diffuse() {
    for (size_t v = 0; v < colours_.size(); ++v) {
      const uint32_t m = uses_.material_of[v];
      if (m != TextureUses::kNone) colours_[v] = materials_[m].diffuse.value_or(kWhite);
    }
  }

  /// Paints the vertices of all materials that have this picture.
  void paint(const Picture& picture, const std::string& path) {
    for (size_t v = 0; v < colours_.size(); ++v) {
      const uint32_t m = uses_.material_of[v];
      const uint32_t t = uses_.coordinate_of[v];
      if (m == TextureUses::kNone || t == TextureUses::kNone) continue;
      if (materials_[m].picture == path) colours_[v] = colour_at(materials_[m], t, picture);
    }
  }

  std::vector<Rgba8> take() {
    const bool is_plain = std::all_of(colours_.begin(), colours_.end(),
                                      [&](const Rgba8& c) { return c == colours_[0]; });
    return is_plain ? std::vector<Rgba8>() : std::move(colours_);
  }

 private:
  /// A material's transparency is its own affair: the surface is drawn as solid.
  Rgba8 colour_at(const Material& material, uint32_t coordinate, const Picture& picture) const {
    const auto& [u, v] = uses_.coordinates[coordinate];
    Rgba8 colour = sample_texture(picture, material.scale[0] * u + material.offset[0],
                                  1 - (material.scale[1] * v + material.offset[1]), material.wraps);
    colour[3] = 255;
    return colour;
  }

  const std::vector<Material>& materials_;
  const TextureUses uses_;
  std::vector<Rgba8> colours_;
};

std::vector<std::string> pictures_of(const std::vector<Material>& materials) {
  std::vector<std::string> paths;
  for (const Material& material : materials)
    if (!material.picture.empty()) paths.push_back(material.picture);
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
  return paths;
}

}  // namespace

Result<std::vector<Rgba8>> obj_texture_colours(std::span<const uint8_t> obj, size_t vertices,
                                               const std::string& path, const FilesBeside& beside,
                                               const std::string& name) {
  const auto files = find_obj_files(obj, path, beside);
  if (!files.is_ok()) return files.status().with_context(name);
  if (files->materials.empty()) return std::vector<Rgba8>();
  ObjPainter painter(files->materials, gather_texture_uses(obj, vertices, files->materials));
  painter.paint_diffuse();
  for (const std::string& each : pictures_of(files->materials)) {
    ASSIGN_OR_RETURN(const auto bytes, beside.read(each));
    const auto picture = read_picture(bytes, name + ": " + each);
    if (picture.status().code() == StatusCode::kUnimplemented) continue;
    RETURN_IF_ERROR(picture.status());
    painter.paint(*picture, each);
  }
  return painter.take();
}

}  // namespace burnish
