#include "client/report/deviation_json.h"

namespace burnish {

nlohmann::ordered_json deviation_json(const Deviation& deviation) {
  const Vec3d& farthest = deviation.farthest;
  return {{"max", deviation.max},
          {"farthest", {farthest.x(), farthest.y(), farthest.z()}},
          {"mean", deviation.mean},
          {"rms", deviation.rms},
          {"outward_max", deviation.outward_max},
          {"inward_max", deviation.inward_max},
          {"mean_along_normal", deviation.mean_along_normal},
          {"area_before", deviation.area_before},
          {"area_after", deviation.area_after},
          {"volume_before", deviation.volume_before},
          {"volume_after", deviation.volume_after},
          {"histogram", {{"range", deviation.histogram_range}, {"area", deviation.histogram}}}};
}

}  // namespace burnish
