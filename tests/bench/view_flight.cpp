#include "tests/bench/view_flight.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace burnish {

using std::chrono::steady_clock;

static constexpr double kSecondsPerLeg = 4;
static constexpr double kNearest = 1.0 / 16;  // of the distance that shows the whole scan
static constexpr int kTenths = 10;

static double resident_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) * 1024 / 1e6;
  return 0;
}

/// One leg: from where the camera is, down to a random side of the scan and up again.
class Leg {
 public:
  Leg(const Camera& from, const Camera& whole, std::minstd_rand& random) : from_(from), to_(whole) {
    std::uniform_real_distribution<double> any(-1, 1);
    to_.azimuth_degrees = 180 * any(random);
    to_.elevation_degrees = 60 * any(random);
    to_.target += 0.3 * whole.scene_radius * Vec3d(any(random), any(random), any(random));
    to_.distance = whole.distance * std::pow(kNearest, std::abs(any(random)));
  }

  Camera at(double part) const {
    const auto mix = [&](double a, double b) { return a + part * (b - a); };
    Camera camera = from_;
    camera.target += part * (to_.target - from_.target);
    camera.distance = from_.distance * std::pow(to_.distance / from_.distance, part);
    camera.azimuth_degrees = mix(from_.azimuth_degrees, to_.azimuth_degrees);
    camera.elevation_degrees = mix(from_.elevation_degrees, to_.elevation_degrees);
    return camera;
  }

 private:
  Camera from_, to_;
};

static double mean_of_tenth(const std::vector<double>& values, int tenth) {
  const size_t begin = values.size() * static_cast<size_t>(tenth) / kTenths;
  const size_t end = std::max(begin + 1, values.size() * static_cast<size_t>(tenth + 1) / kTenths);
  double sum = 0;
  for (size_t i = begin; i < end; ++i) sum += values[i];
  return sum / static_cast<double>(end - begin);
}

Result<FlightFigures> fly(Viewer& viewer, double minutes) {
  std::minstd_rand random(1);
  const Camera whole = viewer.camera;
  std::vector<double> memory;
  const auto end = steady_clock::now() + std::chrono::duration<double>(60 * minutes);
  while (steady_clock::now() < end) {
    const Leg leg(viewer.camera, whole, random);
    const auto start = steady_clock::now();
    for (double part = 0; part < 1;) {
      part = std::min(1.0, ms_between(start, steady_clock::now()) / (1e3 * kSecondsPerLeg));
      viewer.camera = leg.at(part);
      RETURN_IF_ERROR(viewer.picture());
      if (viewer.document().surface().patches().empty())
        return internal_error("a picture of the flight shows nothing");
    }
    RETURN_IF_ERROR(viewer.pictures_for(std::chrono::seconds(1)));
    memory.push_back(resident_mb());
  }
  viewer.camera = whole;
  return FlightFigures{mean_of_tenth(memory, 1), mean_of_tenth(memory, kTenths / 2),
                       mean_of_tenth(memory, kTenths - 1), std::ranges::max(memory), 0};
}

}  // namespace burnish
