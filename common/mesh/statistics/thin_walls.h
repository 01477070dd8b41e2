#pragma once

#include <string>

namespace burnish {

/// The part of a scan's surface that lies on walls thinner than a cell of the finest depth. The two
/// sides of such a wall share corners, so an edit of one side moves the other.
struct ThinWalls {
  double share = 0;  ///< of the area; 0 if it is below kThinWallShareMin
  /// The least depth at which nine tenths of the walls are not thinner than a cell; 0: none up to
  /// kDepthMax.
  int depth = 0;
};

/// Less is not told: a sample does not know it well, and raw scans and noise have about as much.
inline constexpr double kThinWallShareMin = 0.02;

/// Says in a sentence for users what the walls mean for edits; empty where nothing is told.
std::string describe(const ThinWalls& walls);

}  // namespace burnish
