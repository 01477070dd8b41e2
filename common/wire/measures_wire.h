#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/measure/section.h"
#include "common/service/surface_measures.h"

namespace burnish {

v1::Deviation to_wire(const SessionDeviation& measured);
/// Fails: data_loss for another number of bins than Deviation::kBins.
Result<SessionDeviation> from_wire(const v1::Deviation& message);

v1::GetSectionRequest to_wire(const SectionWish& wish);
/// Fails: as make_plane().
Result<SectionWish> from_wire(const v1::GetSectionRequest& message);

/// Rounds the points to float.
v1::Section to_wire(const Section& section, const Plane& plane);
/// Fails: data_loss for a line with an odd number of coordinates, or fewer than two points.
Result<Section> from_wire(const v1::Section& message);

}  // namespace burnish
