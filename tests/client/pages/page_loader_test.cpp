#include "client/pages/page_loader.h"

#include <gtest/gtest.h>

#include "tests/client/pages/page_flight.h"

namespace burnish {
namespace {

TEST(Probe, Flight) {
  const SyntheticScan scan = make_synthetic_scan();
  std::printf("%u pages, %d levels, root %u\n", scan.directory.head.page_count(),
              scan.directory.head.level_count(), scan.directory.entries.back().triangles);
  PageFlight flight(scan, {});
  const Camera whole = camera_over(0.5, 0.5, 2), near = camera_over(0.3, 0.4, 0.05);
  double s = flight.settle(whole);
  std::printf("%.2f s: %s, %zu pages\n", s, status_text(flight.loader().status()).c_str(),
              flight.cut().pages.size());
  flight.fly(whole, near, 60);
  std::printf("flown: %s, %zu pages\n", status_text(flight.loader().status()).c_str(),
              flight.cut().pages.size());
  s = flight.settle(near);
  std::printf("%.2f s: %s, %zu pages\n", s, status_text(flight.loader().status()).c_str(),
              flight.cut().pages.size());
}

}  // namespace
}  // namespace burnish
