// A crew of one: the core has no threads, and no clock that stops for other programs.

#include "client/raster/work_crew.h"

#include <chrono>

#include "client/raster/part_times.h"

namespace burnish {

struct WorkCrew::Others {};

WorkCrew::WorkCrew(int) : threads_(1) {}

WorkCrew::~WorkCrew() = default;

void WorkCrew::run(int parts, const std::function<void(int)>& work) {
  using std::chrono::steady_clock;
  PartTimes times;
  steady_clock::time_point begin = steady_clock::now();
  for (int part = 0; part < parts; ++part) {
    work(part);
    const steady_clock::time_point end = steady_clock::now();
    times.add(std::chrono::duration<double>(end - begin).count());
    begin = end;
  }
  seconds_ += times.seconds();
}

}  // namespace burnish
