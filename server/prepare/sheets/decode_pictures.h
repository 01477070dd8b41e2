#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "common/mesh/textures/surface_textures.h"
#include "server/prepare/sheets/picture_tiles.h"

namespace burnish {

/// Is asked for the bytes of memory and of scratch that come next.
using AdmitBytes = std::function<Status(uint64_t memory_bytes, uint64_t scratch_bytes)>;

/// The pictures that a scan shows.
struct DecodedPictures {
  PictureTiles tiles;
  uint64_t fingerprint = 0;      ///< of their files
  uint64_t count = 0;            ///< that have texels
  std::vector<Status> left_out;  ///< why pictures have none, or not all
};

/// Decodes the pictures that triangles show, one after the other, into a scratch file of a folder.
/// Those beyond kTexturePicturesMax and kTexelsMax are left out, and those that cannot be read
/// unless the textures refuse damage. `name` is for messages. Fails: as a picture cannot be read;
/// as `admit` does; cancelled.
Result<DecodedPictures> decode_pictures(const SurfaceTextures& textures, const std::string& name,
                                        const std::filesystem::path& folder,
                                        const AdmitBytes& admit, const Progress& progress);

}  // namespace burnish
