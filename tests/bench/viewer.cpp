#include "tests/bench/viewer.h"

#include <cmath>
#include <thread>

#include "client/model/documents/open_document.h"
#include "common/base/clock.h"

namespace burnish {

using std::chrono::steady_clock;

static constexpr std::chrono::minutes kViewPatience{2};
/// A view that has not grown for so long is there.
static constexpr std::chrono::milliseconds kQuiet{1000};
static constexpr double kTrembleDegrees = 1e-3;

Result<std::unique_ptr<Viewer>> Viewer::open(const Link& link, const SessionWish& wish) {
  ASSIGN_OR_RETURN(Connection connected,
                   Connection::open(link.address(), std::chrono::seconds(10)));
  const auto connection = std::make_shared<Connection>(std::move(connected));
  ASSIGN_OR_RETURN(const OpenedSession session, connection->open_session(wish));
  std::unique_ptr<Viewer> viewer(new Viewer(link));
  const auto start = steady_clock::now();
  const uint64_t before = link.bytes_down();
  ASSIGN_OR_RETURN(OpenedDocument opened, fetch_document(connection, session.session, {}));
  const auto described = steady_clock::now();
  const uint64_t bytes = link.bytes_down() - before;
  viewer->described = {ms_between(start, described), static_cast<double>(bytes), 0};
  viewer->next_ = steady_clock::now();
  DocumentOptions options;
  options.wake = [] {};
  viewer->document_ = std::make_unique<Document>(std::move(opened), viewer->tasks_, viewer->log_,
                                                 viewer->recorder_, std::move(options));
  RETURN_IF_ERROR(viewer->document_->open(viewer->renderer_));
  viewer->camera = frame_all({.azimuth_degrees = 25, .elevation_degrees = 20},
                             viewer->document_->box(), kSize.aspect());
  return viewer;
}

// A picture that comes late does not make the next ones come faster.
Status Viewer::picture() {
  std::this_thread::sleep_until(next_);
  next_ = std::max(next_, steady_clock::now() - kInterval) + kInterval;
  tasks_.drain();
  document_->update();
  ++pictures_;
  return document_->look(camera, kSize);
}

Status Viewer::pictures_until(const std::function<bool()>& what) {
  const auto end = steady_clock::now() + kViewPatience;
  while (!what()) {
    if (steady_clock::now() > end)
      return unavailable("the view was not there after two minutes: " +
                         status_text(document_->surface().status()));
    RETURN_IF_ERROR(picture());
  }
  return Status::ok();
}

Status Viewer::pictures_for(std::chrono::duration<double> length) {
  const auto start = steady_clock::now();
  return pictures_until([&] { return steady_clock::now() - start >= length; });
}

ViewArrival Viewer::arrived_since(steady_clock::time_point start, uint64_t bytes) const {
  return {ms_between(start, steady_clock::now()), static_cast<double>(link_.bytes_down() - bytes),
          static_cast<double>(document_->surface().status().triangles_drawn)};
}

Result<ViewArrival> Viewer::first_picture() {
  const auto start = steady_clock::now();
  const uint64_t before = link_.bytes_down();
  RETURN_IF_ERROR(pictures_until([&] { return !document_->surface().patches().empty(); }));
  return arrived_since(start, before);
}

Result<ViewArrival> Viewer::prompt_view() {
  const auto start = steady_clock::now();
  const uint64_t before = link_.bytes_down();
  const double azimuth = camera.azimuth_degrees;
  const PagedSurface& surface = document_->surface();
  ViewArrival arrival;
  std::vector<PageId> shown;
  auto grown = start;
  RETURN_IF_ERROR(pictures_until([&] {
    camera.azimuth_degrees = azimuth + (pictures_ % 2 == 0 ? kTrembleDegrees : 0);
    if (shown != surface.drawn_pages()) {
      shown = surface.drawn_pages();
      grown = steady_clock::now();
      arrival = arrived_since(start, before);
    }
    return !shown.empty() && surface.status().reason == CutReason::kMoving &&
           steady_clock::now() - grown > kQuiet;
  }));
  camera.azimuth_degrees = azimuth;
  return arrival;
}

Result<ViewArrival> Viewer::full_view() {
  const auto start = steady_clock::now();
  const uint64_t before = link_.bytes_down();
  RETURN_IF_ERROR(
      pictures_until([&] { return document_->is_settled() && document_->is_picture_settled(); }));
  return arrived_since(start, before);
}

Result<Vec3d> Viewer::middle() {
  const auto hit =
      document_->surface().hit_at(camera, kSize, {kSize.width / 2, kSize.height / 2}, false);
  if (!hit) return not_found("no surface is in the middle of the picture");
  return hit->original;
}

}  // namespace burnish
