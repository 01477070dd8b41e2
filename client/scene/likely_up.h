#pragma once

#include <string_view>

#include <Eigen/Geometry>

#include "client/scene/up_axis.h"
#include "common/mesh/mesh_format.h"

namespace burnish {

/// Guesses the axis of a scan that points up, until its user says it: z for land as surveyors store
/// it, which is flat along z and metres wide; else y. The format glTF says itself that y is up.
/// `box`: the scan's, file units. `unit`: of the coordinates, as its user named it; may be empty.
UpAxis likely_up(const Eigen::AlignedBox3d& box, std::string_view unit, MeshFormat format);

}  // namespace burnish
