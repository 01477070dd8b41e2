// A crew of one: the core has no threads.

#include "client/raster/work_crew.h"

#include <chrono>

namespace burnish {

struct WorkCrew::Others {};

WorkCrew::WorkCrew(int) : threads_(1) {}

WorkCrew::~WorkCrew() = default;

void WorkCrew::run(int parts, const std::function<void(int)>& work) {
  const auto begin = std::chrono::steady_clock::now();
  for (int part = 0; part < parts; ++part) work(part);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace burnish
