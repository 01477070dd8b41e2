#include "tests/bench/view_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace burnish {

using std::chrono::seconds;
using std::chrono::steady_clock;

static constexpr seconds kStill{5}, kDrag{6};
static constexpr double kDabPixels = 15;

// Of values in any order; the largest for 1.
static double quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const double place = part * static_cast<double>(values.size() - 1);
  return values[static_cast<size_t>(std::lround(place))];
}

Result<double> still_view_bytes(Viewer& viewer) {
  RETURN_IF_ERROR(viewer.full_view().status());
  const uint64_t before = viewer.document().stats().bytes;
  RETURN_IF_ERROR(viewer.pictures_for(kStill));
  return static_cast<double>(viewer.document().stats().bytes - before);
}

Result<DragFigures> drag_slider(Viewer& viewer) {
  Document& document = viewer.document();
  std::vector<double> ages, triangles, server_ms;
  uint64_t frames = document.stats().frames;
  const auto start = steady_clock::now();
  double passed = 0;
  while (passed < kDrag.count()) {
    document.preview_beta(1 + std::sin(2 * passed));
    RETURN_IF_ERROR(viewer.picture());
    passed = ms_between(start, steady_clock::now()) / 1e3;
    if (std::exchange(frames, document.stats().frames) == document.stats().frames) continue;
    const FrameStats& made = document.stats().frame;
    server_ms.push_back(made.assemble_ms + made.solve_ms + made.encode_ms);
    ages.push_back(document.stats().age_ms + document.stats().waited_ms);
    triangles.push_back(static_cast<double>(document.surface().status().triangles_drawn));
  }
  document.commit_beta();
  ASSIGN_OR_RETURN(const ViewArrival full, viewer.full_view());
  return DragFigures{quantile(server_ms, 0.5), static_cast<double>(ages.size()) / passed,
                     quantile(ages, 0.5),      quantile(ages, 0.95),
                     quantile(triangles, 0.5), full.ms};
}

Result<DabFigures> paint_dab(Viewer& viewer) {
  Document& document = viewer.document();
  ASSIGN_OR_RETURN(const Vec3d middle, viewer.middle());
  const Brush brush{.radius = kDabPixels * pixel_length(viewer.camera, Viewer::kSize), .beta = 2};
  const uint64_t bytes = document.stats().bytes;
  const uint64_t moves = viewer.renderer().move_count();
  document.paint({brush, {middle}});
  RETURN_IF_ERROR(viewer.full_view().status());
  return DabFigures{document.shown_after_ms(), static_cast<double>(document.stats().bytes - bytes),
                    static_cast<double>(viewer.renderer().move_count() - moves),
                    static_cast<double>(document.surface().drawn_pages().size())};
}

}  // namespace burnish
