#pragma once

#include <string>

#include "common/gltf/primitive.h"

namespace burnish {

/// Private to this folder. Unpacks a primitive's Draco data: its indices, and those of its
/// attributes that `draco`, the extension's object, names. Their types are those of the primitive's
/// accessors. Fails: invalid_argument for damaged data, and for data that unpack to too much.
Status read_draco(UnpackedViews& views, const GltfJson& json, const GltfJson& draco,
                  const std::string& place, GltfPrimitive& primitive);

}  // namespace burnish
