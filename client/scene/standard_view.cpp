#include "client/scene/standard_view.h"

#include <algorithm>
#include <array>
#include <string>

namespace burnish {

static constexpr std::array<std::string_view, kStandardViews> kViewNames = {
    "front", "back", "right", "left", "top", "bottom"};  // as StandardView

std::string_view name_of(StandardView view) {
  return kViewNames[static_cast<size_t>(view)];
}

Result<StandardView> parse_standard_view(std::string_view name) {
  const auto found = std::ranges::find(kViewNames, name);
  if (found != kViewNames.end()) return static_cast<StandardView>(found - kViewNames.begin());
  return invalid_argument("view '" + std::string(name) +
                          "' is not front, back, right, left, top or bottom");
}

Camera seen_from(Camera camera, StandardView view) {
  struct Angles {
    double azimuth, elevation;
  };
  static constexpr std::array<Angles, kStandardViews> kAngles = {
      {{0, 0}, {180, 0}, {90, 0}, {-90, 0}, {0, 90}, {0, -90}}};  // as StandardView
  const Angles& angles = kAngles[static_cast<size_t>(view)];
  camera.azimuth_degrees = angles.azimuth;
  camera.elevation_degrees = angles.elevation;
  return camera;
}

}  // namespace burnish
