#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "client/connection/connection.h"
#include "common/pages/directory.h"
#include "common/pages/page.h"

namespace burnish {

/// The coarsest pages of a scan, which the clients of a session show.
struct LoadSurface {
  int depth = 0;  ///< of the session
  PageHead head;
  uint64_t pages_fingerprint = 0;
  std::vector<std::shared_ptr<const Page>> pages;  ///< by number, so the finest first
  std::vector<Vec3d> points;                       ///< of the pages' vertices, file units
};

/// Pages that clients show unless they are told otherwise: about those that a window shows of a
/// whole scan while the surface moves.
inline constexpr size_t kLoadPages = 32;

/// Fetches at most `pages_max` pages as a window would; 0: as many as a client may show.
/// Fails: as the server says; data_loss (a damaged page).
Result<std::shared_ptr<const LoadSurface>> fetch_load_surface(Connection& connection,
                                                              const std::string& session,
                                                              size_t pages_max);

}  // namespace burnish
