#pragma once

#include <string_view>

#include <Eigen/Core>

#include "common/base/status.h"

namespace burnish {

/// The axis of a scan that points up in the picture.
enum class UpAxis { kX, kY, kZ, kMinusX, kMinusY, kMinusZ };

inline constexpr int kUpAxes = 6;

/// Returns "x", "y", "z", "-x", "-y" or "-z".
std::string_view name_of(UpAxis up);

/// Fails: invalid_argument that names all axes.
Result<UpAxis> parse_up_axis(std::string_view name);

/// Returns the rotation from the scan's axes to those of the turntable, whose y axis is up.
Eigen::Matrix3d to_turntable(UpAxis up);

}  // namespace burnish
