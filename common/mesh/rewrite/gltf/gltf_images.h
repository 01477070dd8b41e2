#pragma once

#include <cstdint>
#include <span>

#include "common/mesh/rewrite/gltf/gltf_edit.h"

namespace burnish {

/// Private to this folder. Puts a picture's new file into an image that is inside a document: in
/// its view, in a view of its own if others use those bytes, or in its data URI. Call after all
/// accessors are put.
void put_gltf_image(GltfEdit& edit, uint32_t image, std::span<const uint8_t> bytes);

}  // namespace burnish
