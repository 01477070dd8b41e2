#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "common/base/status.h"
#include "common/base/types.h"
#include "common/mesh/textures/texture_wrap.h"

namespace burnish {

inline constexpr size_t kTexturePicturesMax = 1024;                         // of a scan
inline constexpr uint64_t kTexelsMax = uint64_t{1} << 33;                   // of a scan
inline constexpr double kTextureCoordinateMax = double(uint64_t{1} << 20);  // magnitude

/// Stands for a material, a picture or a coordinate that is not there.
inline constexpr uint32_t kNoTexture = UINT32_MAX;

/// A picture that materials draw. It is read when its turn comes.
struct SurfacePicture {
  std::string name;  ///< for messages
  std::function<Result<std::vector<uint8_t>>()> read;
  std::string path = {};        ///< among the files beside the mesh; empty: inside its file
  uint32_t image = kNoTexture;  ///< of a glTF file
};

/// The base colour of a material, in linear light.
struct SurfaceMaterial {
  Vec3f factor = Vec3f::Ones();   ///< multiplies the picture
  Vec3f plain = Vec3f::Ones();    ///< the colour where there is no picture or no coordinate
  uint32_t picture = kNoTexture;  ///< index of a SurfacePicture
  TextureWraps wraps;
  /// Takes a texture coordinate into the picture: (0, 0) is the corner of its first pixel in the
  /// top row, (1, 1) that of the last one in the bottom row.
  Eigen::Affine2d to_picture = Eigen::Affine2d::Identity();
};

/// The material of a triangle, and the texture coordinate of each corner.
struct TexturedTriangle {
  uint32_t material = kNoTexture;
  std::array<uint32_t, 3> corners = {kNoTexture, kNoTexture, kNoTexture};
};

/// The base colour of a scan's surface, as an OBJ, a PLY or a glTF file has it.
struct SurfaceTextures {
  std::vector<SurfaceMaterial> materials;
  std::vector<SurfacePicture> pictures;
  std::vector<std::array<float, 2>> coordinates;
  std::vector<TexturedTriangle> triangles;  ///< one per triangle of the mesh; empty: no textures
  bool refuses_damage = false;  ///< else a damaged picture counts as far as it can be read
};

}  // namespace burnish
