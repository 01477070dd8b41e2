#include "client/report/deviation_json.h"

namespace burnish {

nlohmann::ordered_json deviation_json(const Deviation& deviation) {
  auto json = json_of<nlohmann::ordered_json>(deviation);
  const Vec3d& farthest = deviation.farthest;
  json["farthest"] = {farthest.x(), farthest.y(), farthest.z()};
  json["histogram"] = {{"range", deviation.histogram_range}, {"area", deviation.histogram}};
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  if (deviation.axes)
    for (size_t axis = 0; axis < 3; ++axis)
      json["axes"][kAxes[axis]] = json_of<nlohmann::ordered_json>((*deviation.axes)[axis]);
  return json;
}

}  // namespace burnish
