#include "client/report/deviation_json.h"

namespace burnish {

nlohmann::ordered_json deviation_json(const Deviation& deviation) {
  nlohmann::ordered_json json;
#define BURNISH_FIELD(name) json[#name] = deviation.name;
  BURNISH_DEVIATION_NUMBERS(BURNISH_FIELD)
#undef BURNISH_FIELD
  const Vec3d& farthest = deviation.farthest;
  json["farthest"] = {farthest.x(), farthest.y(), farthest.z()};
  json["histogram"] = {{"range", deviation.histogram_range}, {"area", deviation.histogram}};
  return json;
}

}  // namespace burnish
