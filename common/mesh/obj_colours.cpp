#include "common/mesh/obj_colours.h"

#include <algorithm>
#include <map>

#include "common/mesh/obj_files.h"
#include "common/mesh/obj_texture_uses.h"
#include "common/picture/picture_rows.h"
#include "common/picture/texture_samples.h"

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

  /// Paints the vertices of all materials that have this picture. Fails: as read_picture_rows(); as
  /// the budget does.
  Status paint(std::span<const uint8_t> file, const std::string& path, const std::string& name,
               const PictureBudget& budget) {
    const std::vector<uint32_t> vertices = painted_by(path);
    TextureSamples samples(vertices.size());
    PictureSize size;
    const auto begin = [&](const PictureSize& announced) {
      size = announced;
      for (const uint32_t v : vertices) samples.add(place_of(v, size));
      samples.sort();
      return budget ? budget(size.decoding_bytes) : Status::ok();
    };
    const auto take = [&](const PixelRun& run) { samples.take(run); };
    const auto goes_on = [&] { return !budget || budget(0).is_ok(); };
    RETURN_IF_ERROR(read_picture_rows(file, name, {begin, take, goes_on}));
    for (size_t i = 0; i < vertices.size(); ++i) {
      colours_[vertices[i]] = mixed_colour(samples.pixels(i), place_of(vertices[i], size));
      colours_[vertices[i]][3] = 255;  // the surface is drawn as solid, whatever a material says
    }
    return Status::ok();
  }

  std::vector<Rgba8> take() {
    const bool is_plain = std::all_of(colours_.begin(), colours_.end(),
                                      [&](const Rgba8& c) { return c == colours_[0]; });
    return is_plain ? std::vector<Rgba8>() : std::move(colours_);
  }

 private:
  bool is_painted_by(size_t vertex, const std::string& path) const {
    const uint32_t m = uses_.material_of[vertex];
    return m != TextureUses::kNone && uses_.coordinate_of[vertex] != TextureUses::kNone &&
           materials_[m].picture == path;
  }

  std::vector<uint32_t> painted_by(const std::string& path) const {
    std::vector<uint32_t> vertices;
    for (size_t v = 0; v < colours_.size(); ++v)
      if (is_painted_by(v, path)) vertices.push_back(static_cast<uint32_t>(v));
    return vertices;
  }

  /// Returns the pixels around a painted vertex.
  PixelSquare place_of(uint32_t vertex, const PictureSize& size) const {
    const Material& material = materials_[uses_.material_of[vertex]];
    const auto& [u, v] = uses_.coordinates[uses_.coordinate_of[vertex]];
    return pixels_around(material.scale[0] * u + material.offset[0],
                         1 - (material.scale[1] * v + material.offset[1]), size.width, size.height,
                         material.wraps);
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
                                               const MeshSurroundings& beside,
                                               const std::string& name) {
  const auto files = find_obj_files(obj, beside.path, *beside.files);
  if (!files.is_ok()) return files.status().with_context(name);
  if (files->materials.empty()) return std::vector<Rgba8>();
  ObjPainter painter(files->materials, gather_texture_uses(obj, vertices, files->materials));
  painter.paint_diffuse();
  for (const std::string& each : pictures_of(files->materials)) {
    ASSIGN_OR_RETURN(const auto bytes, beside.files->read(each));
    const Status painted = painter.paint(bytes, each, name + ": " + each, beside.pictures);
    if (painted.code() == StatusCode::kUnimplemented) continue;
    RETURN_IF_ERROR(painted);
  }
  return painter.take();
}

}  // namespace burnish
