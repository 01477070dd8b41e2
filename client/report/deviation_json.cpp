#include "client/report/deviation_json.h"

namespace burnish {

nlohmann::ordered_json deviation_json(const Deviation& deviation) {
  auto json = json_of<nlohmann::ordered_json>(deviation);
  const Vec3d& farthest = deviation.farthest;
  json["farthest"] = {farthest.x(), farthest.y(), farthest.z()};
  json["histogram"] = {{"range", deviation.histogram_range}, {"area", deviation.histogram}};
  return json;
}

}  // namespace burnish
