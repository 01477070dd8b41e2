#pragma once

#include <string>

#include "common/measure/deviation.h"
#include "common/measure/plane.h"

namespace burnish {

/// How far a session's edits moved its surface at a moment.
struct SessionDeviation {
  Deviation deviation;
  bool settled = false;  ///< the surface was at the bar of settled sessions
};

/// Asks where a plane cuts a session's surface.
struct SectionWish {
  std::string session;  ///< name or id
  Plane plane;
};

}  // namespace burnish
