// A crew of one: the core has no threads.

#include "client/raster/work_crew.h"

namespace burnish {

struct WorkCrew::Others {};

WorkCrew::WorkCrew(int) : threads_(1) {}

WorkCrew::~WorkCrew() = default;

void WorkCrew::run(int parts, const std::function<void(int)>& work) {
  for (int part = 0; part < parts; ++part) work(part);
}

}  // namespace burnish
