#include "common/mesh/gltf/gltf_textures.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "common/gltf/data_uri.h"
#include "common/mesh/gltf/gltf_materials.h"

namespace burnish {

namespace {

/// Reads an image: embedded, a data URI, or a file beside.
class GltfImage {
 public:
  GltfImage(UnpackedViews& views, const MeshSurroundings& beside, uint32_t image)
      : views_(views),
        beside_(beside),
        json_(views.document().json.at("images")[image]),
        place_(place_text("image", image)) {}

  Result<std::vector<uint8_t>> read() const {
    if (const auto uri = written_uri()) return read_uri(*uri);
    ASSIGN_OR_RETURN(const uint64_t index, read_whole(json_, "bufferView", place_));
    ASSIGN_OR_RETURN(const GltfView view, views_.view(index, place_));
    return std::vector<uint8_t>(view.bytes.begin(), view.bytes.end());
  }

  /// Returns the path of its file; empty if it is embedded, or missing.
  std::string path() const {
    const auto uri = written_uri();
    if (!uri || uri->starts_with("data:") || beside_.files == nullptr) return {};
    return beside_.files->find(folder_of(beside_.path), unescaped_uri(*uri)).value_or("");
  }

 private:
  std::optional<std::string_view> written_uri() const {
    const GltfJson* uri = find_member(json_, "uri");
    if (uri == nullptr || !uri->is_string()) return std::nullopt;
    return std::string_view(uri->get_ref<const std::string&>());
  }

  Result<std::vector<uint8_t>> read_uri(std::string_view uri) const {
    if (!is_data_uri(uri)) return read_file(unescaped_uri(uri));
    return read_data_uri(uri, place_, FileSteps(beside_.budget));
  }

  Result<std::vector<uint8_t>> read_file(const std::string& name) const {
    const auto path = beside_.files == nullptr ? std::nullopt
                                               : beside_.files->find(folder_of(beside_.path), name);
    if (!path) return not_found(place_ + ": the file '" + name + "' is not beside it");
    return beside_.files->read(*path);
  }

  UnpackedViews& views_;
  const MeshSurroundings& beside_;
  const GltfJson& json_;
  const std::string place_;
};

class GltfTextureReader {
 public:
  GltfTextureReader(UnpackedViews& views, const GltfSurface& surface,
                    const MeshSurroundings& beside)
      : views_(views),
        surface_(surface),
        beside_(beside),
        materials_(read_gltf_materials(views.document())) {}

  SurfaceTextures read() {
    if (is_plain() || !views_.charge(bytes_to_come()).is_ok()) return {};
    for (const GltfMaterial& material : materials_) add_material(material.surface);
    textures_.triangles.reserve(surface_.mesh.triangles.size());
    for (const GltfPart& part : surface_.parts) add_part(part);
    return std::move(textures_);
  }

 private:
  /// A range of the textures' coordinates.
  struct Coordinates {
    uint32_t first = kNoTexture;
    uint64_t count = 0;
  };

  /// Returns what the textures and the colours made of them take, but for coordinates.
  uint64_t bytes_to_come() const {
    constexpr uint64_t kVertexBytes = 36;
    return surface_.mesh.triangles.size() * sizeof(TexturedTriangle) +
           surface_.mesh.vertices.size() * kVertexBytes;
  }

  /// Returns whether all materials are white without pictures.
  bool is_plain() const {
    return std::ranges::all_of(materials_, [](const GltfMaterial& material) {
      return material.surface.picture == kNoTexture && material.surface.plain == Vec3f::Ones();
    });
  }

  void add_material(SurfaceMaterial material) {
    if (material.picture != kNoTexture) material.picture = picture_number(material.picture);
    textures_.materials.push_back(material);
  }

  uint32_t picture_number(uint32_t image) {
    const auto [found, is_new] =
        pictures_.emplace(image, static_cast<uint32_t>(textures_.pictures.size()));
    if (is_new) {
      const GltfImage reader(views_, beside_, image);
      textures_.pictures.push_back(
          {place_text("image", image), [reader] { return reader.read(); }, reader.path(), image});
    }
    return found->second;
  }

  void add_part(const GltfPart& part) {
    const uint32_t material = material_of(*part.primitive);
    const uint32_t first =
        material == kNoTexture ? kNoTexture : coordinates_of(*part.primitive, material).first;
    const bool is_mirrored =
        surface_.placements[part.placement].to_scene.linear().determinant() < 0;
    const auto corner = [&](uint32_t i) { return first == kNoTexture ? kNoTexture : first + i; };
    for_each_triangle(*part.primitive, [&](uint32_t a, uint32_t b, uint32_t c) {
      views_.steps().take();
      if (is_mirrored) std::swap(b, c);
      textures_.triangles.push_back({material, {corner(a), corner(b), corner(c)}});
    });
  }

  const GltfJson& json_of(const GltfPrimitive& primitive) const {
    return views_.document().json.at("meshes")[primitive.mesh].at("primitives")[primitive.number];
  }

  uint32_t material_of(const GltfPrimitive& primitive) const {
    const auto number = read_whole(json_of(primitive), "material", "");
    return number.is_ok() && *number < materials_.size() ? static_cast<uint32_t>(*number)
                                                         : kNoTexture;
  }

  /// Returns the texture coordinates of a primitive, one per position, or none. Many primitives may
  /// share them, and many nodes a primitive.
  Coordinates coordinates_of(const GltfPrimitive& primitive, uint32_t material) {
    const std::string& name = materials_[material].coordinates;
    const GltfJson* attributes = find_object(json_of(primitive), {"attributes"});
    const auto index = read_whole(*attributes, name.c_str(), "");
    if (name.empty() || !index.is_ok()) return {};
    const uint64_t mesh = primitive.is_draco ? primitive.mesh : kNoAccessor;
    const uint64_t number = primitive.is_draco ? primitive.number : kNoAccessor;
    const auto [found, is_new] = coordinates_.try_emplace({*index, mesh, number});
    if (is_new) found->second = add_coordinates(primitive, name, *index);
    return found->second.count == primitive.positions().count ? found->second : Coordinates();
  }

  Coordinates add_coordinates(const GltfPrimitive& primitive, const std::string& name,
                              uint64_t index) {
    const GltfAccessor* kept = primitive.find(name);  // Draco's are in no accessor
    const auto read =
        kept != nullptr ? Result<GltfAccessor>(*kept) : read_accessor(views_, index, "");
    auto& all = textures_.coordinates;
    if (!read.is_ok() || read->element.components != 2 || read->count >= kNoTexture - all.size() ||
        !views_.charge(read->count * sizeof all[0]).is_ok())
      return {};
    const Coordinates added = {static_cast<uint32_t>(all.size()), read->count};
    for (uint64_t i = 0; i < read->count; ++i) {
      views_.steps().take();
      all.push_back({read->number(i, 0), read->number(i, 1)});
    }
    return added;
  }

  UnpackedViews& views_;
  const GltfSurface& surface_;
  const MeshSurroundings& beside_;
  const std::vector<GltfMaterial> materials_;
  std::map<uint32_t, uint32_t> pictures_;                                        // by image
  std::map<std::tuple<uint64_t, uint64_t, uint64_t>, Coordinates> coordinates_;  // by accessor
  SurfaceTextures textures_;
};

}  // namespace

SurfaceTextures read_gltf_textures(UnpackedViews& views, const GltfSurface& surface,
                                   const MeshSurroundings& beside) {
  return GltfTextureReader(views, surface, beside).read();
}

}  // namespace burnish
