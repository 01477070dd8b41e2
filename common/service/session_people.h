#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/base/record.h"
#include "common/base/types.h"
#include "common/service/session_roles.h"

namespace burnish {

/// The place and size of somebody's brush, in file units.
struct BrushRing {
  Vec3d centre = Vec3d::Zero();
  double radius = 0;
  bool operator==(const BrushRing&) const = default;
};

/// Somebody who is in a session now; one for each of their connections.
struct PresentUser {
  uint64_t connection = 0;  ///< the server's choice
  std::string user;
  uint32_t colour = 0;            ///< 0xRRGGBB, sRGB
  std::optional<BrushRing> ring;  ///< while the brush is over the surface
  bool operator==(const PresentUser&) const = default;
};
BURNISH_RECORD(PresentUser, connection, user, colour)

/// Who may do what, and who is there.
struct SessionPeople {
  SessionRoles roles;
  std::vector<PresentUser> present;  ///< in the order of their coming
};

}  // namespace burnish
