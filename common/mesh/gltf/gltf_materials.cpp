#include "common/mesh/gltf/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burnish {

/// Returns an element of an array of the document; null if it is not an object that exists.
static const GltfJson* element_or_null(const GltfDocument& document, const char* array,
                                       std::optional<uint64_t> index) {
  if (!index) return nullptr;
  const auto found = find_element(document.json, array, *index, "");
  return found.is_ok() ? *found : nullptr;
}

static std::optional<uint64_t> whole_or_none(const GltfJson& object, const char* name) {
  const auto value = read_whole(object, name, "");
  return value.is_ok() ? std::optional(*value) : std::nullopt;
}

/// Reads numbers of an array over those that are there. Leaves them if one of them is damaged.
template <typename Numbers>
static void read_numbers(const GltfJson& object, const char* name, Numbers& numbers) {
  const GltfJson* array = find_member(object, name);
  const auto count = static_cast<size_t>(numbers.size());
  if (array == nullptr || !array->is_array() || array->size() < count) return;
  const auto is_number = [](const GltfJson& value) { return value.is_number(); };
  if (!std::all_of(array->begin(), array->begin() + static_cast<ptrdiff_t>(count), is_number))
    return;
  for (size_t i = 0; i < count; ++i)
    numbers[static_cast<Eigen::Index>(i)] = (*array)[i].get<typename Numbers::Scalar>();
}

static TextureWrap wrap_of(const GltfJson& sampler, const char* name) {
  constexpr uint64_t kClampToEdge = 33071, kMirroredRepeat = 33648;  // as OpenGL numbers them
  const auto number = whole_or_none(sampler, name);
  if (number == kClampToEdge) return TextureWrap::kClamp;
  return number == kMirroredRepeat ? TextureWrap::kMirror : TextureWrap::kRepeat;
}

/// Reads KHR_texture_transform: scaled, then turned counter-clockwise as v points down, then moved.
static Eigen::Affine2d read_transform(const GltfJson& json) {
  Eigen::Vector2d scale = {1, 1}, offset = {0, 0};
  read_numbers(json, "scale", scale);
  read_numbers(json, "offset", offset);
  const GltfJson* rotation = find_member(json, "rotation");
  const double angle = rotation != nullptr && rotation->is_number() ? rotation->get<double>() : 0.0;
  return Eigen::Translation2d(offset) * Eigen::Rotation2Dd(-angle) * Eigen::Scaling(scale);
}

/// Returns a texture's image: first of the extensions' that are read, then its own, then of those
/// that are not, so that its kind can be told.
static std::optional<uint64_t> image_of(const GltfJson& texture) {
  const auto of_extension = [&](const char* name) {
    const GltfJson* json = find_object(texture, {"extensions", name});
    return json == nullptr ? std::nullopt : whole_or_none(*json, "source");
  };
  if (const auto webp = of_extension("EXT_texture_webp")) return webp;
  if (const auto own = whole_or_none(texture, "source")) return own;
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"})
    if (const auto other = of_extension(name)) return other;
  return std::nullopt;
}

/// Reads the texture that a material refers to.
static void read_texture(const GltfDocument& document, const GltfJson& info,
                         GltfMaterial& material) {
  const GltfJson* texture = element_or_null(document, "textures", whole_or_none(info, "index"));
  if (texture == nullptr) return;
  const auto image = image_of(*texture);
  if (element_or_null(document, "images", image) == nullptr || *image >= kNoTexture) return;
  SurfaceMaterial& surface = material.surface;
  surface.picture = static_cast<uint32_t>(*image);
  uint64_t set = whole_or_none(info, "texCoord").value_or(0);
  if (const GltfJson* json = find_object(info, {"extensions", "KHR_texture_transform"})) {
    surface.to_picture = read_transform(*json);
    set = whole_or_none(*json, "texCoord").value_or(set);
  }
  material.coordinates = "TEXCOORD_" + std::to_string(set);
  const GltfJson* sampler =
      element_or_null(document, "samplers", whole_or_none(*texture, "sampler"));
  if (sampler != nullptr) surface.wraps = {wrap_of(*sampler, "wrapS"), wrap_of(*sampler, "wrapT")};
}

/// The names of a material's colour: of glTF itself, and of an older extension.
struct ColourNames {
  std::initializer_list<const char*> look;
  const char* factor;
  const char* texture;
};

static GltfMaterial read_colour(const GltfDocument& document, const GltfJson& json,
                                const ColourNames& names) {
  GltfMaterial material;
  const GltfJson* look = find_object(json, names.look);
  if (look == nullptr) return material;
  SurfaceMaterial& surface = material.surface;
  read_numbers(*look, names.factor, surface.factor);
  surface.factor = surface.factor.cwiseMax(0.F).cwiseMin(1.F);
  surface.plain = surface.factor;
  if (const GltfJson* info = find_object(*look, {names.texture}))
    read_texture(document, *info, material);
  return material;
}

/// Returns whether a surface has a colour but for the light that it gives: its file names one, and
/// it is not black.
static bool reflects(const GltfJson& json, const SurfaceMaterial& surface) {
  constexpr float kBlack = 0.01F;
  return find_object(json, {"pbrMetallicRoughness"}) != nullptr &&
         surface.factor.maxCoeff() > kBlack;
}

/// Some programs write a scan's photos as light that a black surface gives.
static GltfMaterial read_light(const GltfDocument& document, const GltfJson& json,
                               const GltfMaterial& otherwise) {
  GltfMaterial light;
  light.surface.factor = Vec3f::Zero();  // as glTF has it
  read_numbers(json, "emissiveFactor", light.surface.factor);
  light.surface.factor = light.surface.factor.cwiseMax(0.F).cwiseMin(1.F);
  light.surface.plain = light.surface.factor;
  if (const GltfJson* info = find_object(json, {"emissiveTexture"}))
    read_texture(document, *info, light);
  return light.surface.picture == kNoTexture || light.surface.factor.isZero() ? otherwise : light;
}

/// Files with the extension may have a material without a picture beside it, for who does not know
/// it.
static GltfMaterial read_material(const GltfDocument& document, const GltfJson& json) {
  constexpr const char* kOlder = "KHR_materials_pbrSpecularGlossiness";
  const GltfMaterial material = read_colour(
      document, json, {{"pbrMetallicRoughness"}, "baseColorFactor", "baseColorTexture"});
  if (material.surface.picture != kNoTexture) return material;
  if (find_object(json, {"extensions", kOlder}) != nullptr)
    return read_colour(document, json, {{"extensions", kOlder}, "diffuseFactor", "diffuseTexture"});
  return reflects(json, material.surface) ? material : read_light(document, json, material);
}

std::vector<GltfMaterial> read_gltf_materials(const GltfDocument& document) {
  std::vector<GltfMaterial> materials;
  for (size_t m = 0; m < count_elements(document.json, "materials"); ++m)
    materials.push_back(read_material(document, document.json.at("materials")[m]));
  return materials;
}

}  // namespace burnish
