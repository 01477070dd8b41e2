#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <draco/mesh/mesh.h>

#include "common/base/status.h"
#include "common/gltf/unpacked_views.h"

namespace burnish {

/// Private to this folder. Decodes Draco's bytes to a mesh. Charges the views before memory is
/// taken. Fails: invalid_argument that begins with `place`, resource_exhausted.
Status decode_draco(UnpackedViews& views, std::span<const uint8_t> bytes, const std::string& place,
                    draco::Mesh& mesh);

}  // namespace burnish
