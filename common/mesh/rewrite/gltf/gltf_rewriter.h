#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "common/gltf/document.h"
#include "common/mesh/output_buffer.h"
#include "common/mesh/rewrite/gltf/gltf_edit.h"
#include "common/mesh/rewrite/moved/moved_mesh.h"
#include "common/mesh/rewrite/pictures/edited_pictures.h"

namespace burnish {

/// Writes a .glb or .gltf file again with new positions and normals, in each node's own frame, and
/// with those of `pictures` that are inside it. All else keeps its value: JSON members and their
/// order, other accessors, images. A mesh that did not move gives the same bytes. Adds to `changed`
/// the files that `beside` gave and that have new bytes. Fails: data_loss if `moved` was not read
/// from these bytes; as the sink does.
Status rewrite_gltf(std::span<const uint8_t> bytes, const std::string& name,
                    const GltfFilesBeside& beside, const MovedMesh& moved,
                    std::span<const EditedPicture> pictures, OutputBuffer& output,
                    std::vector<GltfFileBeside>& changed);

}  // namespace burnish
