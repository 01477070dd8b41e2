#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/gltf/document.h"
#include "common/mesh/textures/surface_textures.h"

namespace burnish {

/// A material of a glTF file, and where its texture lies.
struct GltfMaterial {
  SurfaceMaterial surface;       ///< `picture` is the number of an image of the document
  std::string coordinates = {};  ///< the attribute, such as TEXCOORD_0; empty: no texture
};

/// Reads the base colours of a document's materials. Anything damaged counts as none.
std::vector<GltfMaterial> read_gltf_materials(const GltfDocument& document);

}  // namespace burnish
