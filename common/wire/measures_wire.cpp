#include "common/wire/measures_wire.h"

#include <algorithm>

#include "common/wire/format_wire.h"

namespace burnish {

v1::Deviation to_wire(const SessionDeviation& measured) {
  const Deviation& deviation = measured.deviation;
  v1::Deviation message;
  message.set_max(deviation.max);
  *message.mutable_farthest() = to_wire(deviation.farthest);
  message.set_mean(deviation.mean);
  message.set_rms(deviation.rms);
  message.set_outward_max(deviation.outward_max);
  message.set_inward_max(deviation.inward_max);
  message.set_mean_along_normal(deviation.mean_along_normal);
  message.set_area_before(deviation.area_before);
  message.set_area_after(deviation.area_after);
  message.set_volume_before(deviation.volume_before);
  message.set_volume_after(deviation.volume_after);
  message.set_histogram_range(deviation.histogram_range);
  message.mutable_histogram()->Assign(deviation.histogram.begin(), deviation.histogram.end());
  message.set_settled(measured.settled);
  return message;
}

Result<SessionDeviation> from_wire(const v1::Deviation& message) {
  if (message.histogram_size() != Deviation::kBins)
    return data_loss("the deviation has " + std::to_string(message.histogram_size()) +
                     " bins, expected " + std::to_string(Deviation::kBins));
  SessionDeviation measured;
  Deviation& deviation = measured.deviation;
  deviation.max = message.max();
  deviation.farthest = from_wire(message.farthest());
  deviation.mean = message.mean();
  deviation.rms = message.rms();
  deviation.outward_max = message.outward_max();
  deviation.inward_max = message.inward_max();
  deviation.mean_along_normal = message.mean_along_normal();
  deviation.area_before = message.area_before();
  deviation.area_after = message.area_after();
  deviation.volume_before = message.volume_before();
  deviation.volume_after = message.volume_after();
  deviation.histogram_range = message.histogram_range();
  std::ranges::copy(message.histogram(), deviation.histogram.begin());
  measured.settled = message.settled();
  return measured;
}

v1::GetSectionRequest to_wire(const SectionWish& wish) {
  v1::GetSectionRequest message;
  message.set_session(wish.session);
  *message.mutable_point() = to_wire(wish.plane.point);
  *message.mutable_direction() = to_wire(wish.plane.normal);
  return message;
}

Result<SectionWish> from_wire(const v1::GetSectionRequest& message) {
  ASSIGN_OR_RETURN(const Plane plane,
                   make_plane(from_wire(message.point()), from_wire(message.direction())));
  return SectionWish{message.session(), plane};
}

static v1::SectionLine to_wire(const SectionLine& line) {
  v1::SectionLine message;
  for (const Eigen::Vector2d& point : line.points) {
    message.add_points(static_cast<float>(point.x()));
    message.add_points(static_cast<float>(point.y()));
  }
  return message;
}

static Result<SectionLine> from_wire(const v1::SectionLine& message) {
  if (message.points_size() % 2 != 0 || message.points_size() < 4)
    return data_loss("a line of the section has " + std::to_string(message.points_size()) +
                     " coordinates");
  SectionLine line;
  for (int i = 0; i < message.points_size(); i += 2)
    line.points.emplace_back(message.points(i), message.points(i + 1));
  return line;
}

v1::Section to_wire(const Section& section, const Plane& plane) {
  v1::Section message;
  for (const SectionLine& line : section.original) *message.add_original() = to_wire(line);
  for (const SectionLine& line : section.edited) *message.add_edited() = to_wire(line);
  const PlaneAxes axes = axes_of(plane);
  *message.mutable_right() = to_wire(axes.right);
  *message.mutable_up() = to_wire(axes.up);
  return message;
}

Result<Section> from_wire(const v1::Section& message) {
  Section section;
  for (const v1::SectionLine& line : message.original()) {
    ASSIGN_OR_RETURN(SectionLine taken, from_wire(line));
    section.original.push_back(std::move(taken));
  }
  for (const v1::SectionLine& line : message.edited()) {
    ASSIGN_OR_RETURN(SectionLine taken, from_wire(line));
    section.edited.push_back(std::move(taken));
  }
  return section;
}

}  // namespace burnish
