#include "tests/bench/view_case.h"

#include "tests/bench/view_flight.h"
#include "tests/bench/view_motion.h"
#include "tests/bench/viewer.h"

namespace burnish {

static Status measure_views(Viewer& viewer, ViewFigures& figures) {
  ASSIGN_OR_RETURN(figures.first, viewer.first_picture());
  ASSIGN_OR_RETURN(figures.whole, viewer.prompt_view());
  viewer.camera.distance /= 2;
  ASSIGN_OR_RETURN(figures.zoomed, viewer.prompt_view());
  viewer.camera.distance *= 2;
  ASSIGN_OR_RETURN(figures.full, viewer.full_view());
  return Status::ok();
}

static Result<double> first_picture_ms(const Link& link, const SessionWish& wish) {
  ASSIGN_OR_RETURN(const std::unique_ptr<Viewer> viewer, Viewer::open(link, wish));
  ASSIGN_OR_RETURN(const ViewArrival first, viewer->first_picture());
  return viewer->described.ms + first.ms;
}

Result<ViewFigures> run_view_case(const ViewCase& what) {
  const Link link(what.server, {.megabits_per_second = what.megabits_per_second});
  ViewFigures figures;
  ASSIGN_OR_RETURN(figures.unsolved_ms, first_picture_ms(link, what.wish));
  ASSIGN_OR_RETURN(const std::unique_ptr<Viewer> viewer, Viewer::open(link, what.wish));
  figures.described = viewer->described;
  RETURN_IF_ERROR(measure_views(*viewer, figures));
  ASSIGN_OR_RETURN(figures.still_bytes, still_view_bytes(*viewer));
  ASSIGN_OR_RETURN(figures.dab, paint_dab(*viewer));
  ASSIGN_OR_RETURN(figures.drag, drag_slider(*viewer));
  if (what.flight_minutes > 0) {
    const uint64_t before = link.bytes_down();
    ASSIGN_OR_RETURN(figures.flight, fly(*viewer, what.flight_minutes));
    figures.flight.fetched_mb = static_cast<double>(link.bytes_down() - before) / 1e6;
  }
  return figures;
}

}  // namespace burnish
