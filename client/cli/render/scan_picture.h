#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/pictures/picture.h"
#include "common/base/status.h"

namespace burnish {

/// Colours of the surface in a picture of a scan's file.
enum class ScanColours {
  kIfAny,   ///< the scan's own, if it has some
  kNeeded,  ///< the scan's own
  kNone,
};

struct ScanPicture {
  Image image;
  Camera camera;                      ///< its own
  bool is_textured = false;           ///< shows the texels of the scan's pictures
  std::vector<std::string> warnings;  ///< what it lacks
};

/// Draws one picture of a mesh file. A scan with pictures shows their texels. Where that fails, it
/// shows their mean colours at its vertices, and a warning says why.
/// Fails: as read_mesh() and draw_picture(); failed_precondition for needed colours that the scan
/// does not have, with the warnings.
Result<ScanPicture> draw_scan_picture(const std::filesystem::path& scan,
                                      const PictureOptions& options, ScanColours colours);

}  // namespace burnish
