#include "client/scene/up_axis.h"

#include <algorithm>
#include <array>
#include <string>

namespace burnish {

static constexpr std::array<std::string_view, kUpAxes> kUpNames = {"x",  "y",  "z",
                                                                   "-x", "-y", "-z"};  // as UpAxis

std::string_view name_of(UpAxis up) {
  return kUpNames[static_cast<size_t>(up)];
}

Result<UpAxis> parse_up_axis(std::string_view name) {
  const auto found = std::ranges::find(kUpNames, name);
  if (found != kUpNames.end()) return static_cast<UpAxis>(found - kUpNames.begin());
  return invalid_argument("up axis '" + std::string(name) + "' is not x, y, z, -x, -y or -z");
}

Eigen::Matrix3d to_turntable(UpAxis up) {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  if (up == UpAxis::kX) rows << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  if (up == UpAxis::kZ) rows << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  if (up == UpAxis::kMinusX) rows << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  if (up == UpAxis::kMinusY) rows << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  if (up == UpAxis::kMinusZ) rows << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return rows;
}

}  // namespace burnish
