#include "common/wire/measures_wire.h"

#include <algorithm>

#include "common/wire/format_wire.h"

namespace burnish {

v1::Deviation to_wire(const SessionDeviation& measured) {
  const Deviation& deviation = measured.deviation;
  v1::Deviation message;
  write_fields(deviation, message);
  *message.mutable_farthest() = to_wire(deviation.farthest);
  message.set_histogram_range(deviation.histogram_range);
  for (const double fraction : deviation.histogram) message.add_histogram(fraction);
  message.set_settled(measured.settled);
  if (deviation.axes)
    for (const AxisMoves& moves : *deviation.axes) write_fields(moves, *message.add_axes());
  return message;
}

Result<SessionDeviation> from_wire(const v1::Deviation& message) {
  if (message.histogram_size() != Deviation::kBins)
    return data_loss("the deviation has " + std::to_string(message.histogram_size()) +
                     " bins, expected " + std::to_string(Deviation::kBins));
  SessionDeviation measured;
  Deviation& deviation = measured.deviation;
  read_fields(message, deviation);
  deviation.farthest = from_wire(message.farthest());
  deviation.histogram_range = message.histogram_range();
  std::ranges::copy(message.histogram(), deviation.histogram.begin());
  measured.settled = message.settled();
  if (message.axes_size() == 0) return measured;  // of an older server
  if (message.axes_size() != 3)
    return data_loss("the deviation has " + std::to_string(message.axes_size()) +
                     " axes, expected 3");
  deviation.axes.emplace();
  for (int axis = 0; axis < 3; ++axis)
    read_fields(message.axes(axis), (*deviation.axes)[static_cast<size_t>(axis)]);
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
