#pragma once

#include <cstdint>
#include <string>

#include "common/base/status.h"
#include "common/service/session_info.h"

namespace burnish {

/// What has come until a view was there.
struct ViewArrival {
  double ms = 0;
  double bytes = 0;  ///< on the link towards the client
  double triangles = 0;
};

struct DragFigures {
  double server_ms = 0;            ///< that it takes for a frame, median
  double pictures_per_second = 0;  ///< that show a newer frame
  double age_p50_ms = 0;           ///< of frames when they are drawn
  double age_p95_ms = 0;
  double triangles = 0;      ///< drawn, median
  double full_after_ms = 0;  ///< from the end of the drag to full detail
};

struct DabFigures {
  double ms = 0;           ///< from the edit to the first frame that shows it
  double bytes = 0;        ///< of frames, until all is settled
  double moved_pages = 0;  ///< on the card, summed over the frames
  double shown_pages = 0;  ///< in view
};

/// Resident memory of this process, all of it.
struct FlightFigures {
  double begin_mb = 0;   ///< mean of the second tenth of the flight
  double middle_mb = 0;  ///< of the sixth tenth
  double end_mb = 0;     ///< of the last tenth
  double most_mb = 0;
  double fetched_mb = 0;
};

/// All that is measured over one link.
struct ViewFigures {
  double unsolved_ms = 0;  ///< until the first picture of a session that the server has not solved
  ViewArrival described;   ///< from the answer of OpenSession until all but the surface is known
  ViewArrival first;       ///< from there until the first picture that shows any surface
  ViewArrival whole;       ///< from there until the view with errors of 1 and edges of 6 pixels
  ViewArrival zoomed;      ///< the same twice as near
  ViewArrival full;        ///< the whole in full detail, from there
  double still_bytes = 0;
  DragFigures drag;
  DabFigures dab;
  FlightFigures flight;
};

struct ViewCase {
  std::string server;
  SessionWish wish;
  double megabits_per_second = 50;
  double flight_minutes = 0;
};

/// Opens the session as a window does, over a link with a round trip of 40 ms. Measures the first
/// picture, then all figures with another window.
Result<ViewFigures> run_view_case(const ViewCase& what);

}  // namespace burnish
