#include "common/mesh/obj/obj_textures.h"

#include <map>
#include <string_view>
#include <utility>

#include "common/mesh/obj/obj_files.h"
#include "common/mesh/reading/text_scanner.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/srgb.h"

namespace burnish {

namespace {

/// Returns the place from 0 that an OBJ's index means, or kNoTexture.
uint32_t place_from_zero(std::string_view token, size_t so_far) {
  int64_t index;
  if (!parse_integer(token, index) || index == 0) return kNoTexture;
  const int64_t place = index < 0 ? static_cast<int64_t>(so_far) + index : index - 1;
  if (place < 0 || place >= int64_t{kNoTexture}) return kNoTexture;
  return static_cast<uint32_t>(place);
}

/// Returns the second number of "7/2/5" as text; empty if there is none.
std::string_view coordinate_of_corner(std::string_view token) {
  const size_t slash = token.find('/');
  if (slash == std::string_view::npos) return {};
  token.remove_prefix(slash + 1);
  return token.substr(0, token.find('/'));
}

/// Returns -s and -o of a texture, whose v counts from the bottom.
Eigen::Affine2d picture_transform(const Material& material) {
  Eigen::Affine2d to_picture = Eigen::Affine2d::Identity();
  to_picture.linear().diagonal() << material.scale[0], -material.scale[1];
  to_picture.translation() << material.offset[0], 1 - material.offset[1];
  return to_picture;
}

/// Walks through an OBJ file and keeps what each triangle shows.
class ObjTextureReader {
 public:
  ObjTextureReader(std::span<const uint8_t> obj, const MeshSurroundings& beside)
      : scanner_(obj, "", {.hash_comments = true, .backslash_continues = true}, 0,
                 FileSteps(beside.budget)),
        files_(*beside.files) {}

  SurfaceTextures read(const std::vector<Material>& materials) {
    textures_.refuses_damage = true;
    for (const Material& material : materials) add_material(material);
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "vt") read_coordinate();
      if (keyword == "usemtl") read_material();
      if (keyword == "f") read_face();
    }
    return std::move(textures_);
  }

 private:
  void add_material(const Material& material) {
    materials_.emplace(material.name, static_cast<uint32_t>(textures_.materials.size()));
    SurfaceMaterial& added = textures_.materials.emplace_back();
    if (material.diffuse) added.plain = linear_colour(*material.diffuse);
    if (!material.picture.empty()) added.picture = picture_number(material.picture);
    added.wraps = material.wraps;
    added.to_picture = picture_transform(material);
  }

  uint32_t picture_number(const std::string& path) {
    const auto [found, is_new] =
        pictures_.emplace(path, static_cast<uint32_t>(textures_.pictures.size()));
    if (is_new)
      textures_.pictures.push_back(
          {path, [&files = files_, path] { return files.read(path); }, path});
    return found->second;
  }

  void read_coordinate() {
    std::array<float, 2> uv = {0, 0};
    for (float& x : uv) {
      double value;
      if (!parse_double(scanner_.next_token(), value)) break;
      x = static_cast<float>(value);
    }
    textures_.coordinates.push_back(uv);
  }

  void read_material() {
    std::string_view name = scanner_.line_rest();
    while (!name.empty() && (name.front() == ' ' || name.front() == '\t')) name.remove_prefix(1);
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
    const auto found = materials_.find(name);
    material_ = found == materials_.end() ? kNoTexture : found->second;
  }

  /// Makes the triangles of append_fan().
  void read_face() {
    TexturedTriangle fan = {.material = material_};
    size_t corners = 0;
    for (std::string_view token; !(token = scanner_.next_token()).empty(); ++corners) {
      if (corners > 0) fan.corners[1] = fan.corners[2];
      fan.corners[corners == 0 ? 0 : 2] =
          place_from_zero(coordinate_of_corner(token), textures_.coordinates.size());
      if (corners > 1) textures_.triangles.push_back(fan);
    }
  }

  TextScanner scanner_;
  const FilesBeside& files_;
  std::map<std::string, uint32_t, std::less<>> materials_;
  std::map<std::string, uint32_t> pictures_;
  SurfaceTextures textures_;
  uint32_t material_ = kNoTexture;
};

}  // namespace

Result<SurfaceTextures> read_obj_textures(std::span<const uint8_t> obj,
                                          const MeshSurroundings& beside) {
  ASSIGN_OR_RETURN(const ObjFiles files, find_obj_files(obj, beside));
  if (files.materials.empty()) return SurfaceTextures();
  return ObjTextureReader(obj, beside).read(files.materials);
}

}  // namespace burnish
