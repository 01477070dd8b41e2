#pragma once

#include <string_view>

#include "client/scene/camera.h"

namespace burnish {

/// The six views along the turntable's axes.
enum class StandardView { kFront, kBack, kRight, kLeft, kTop, kBottom };

inline constexpr int kStandardViews = 6;

/// Returns the word for a view, e.g. "front".
std::string_view name_of(StandardView view);

/// Fails: invalid_argument that names all views.
Result<StandardView> parse_standard_view(std::string_view name);

/// Turns around the target. The front is seen along -z when y is up.
Camera seen_from(Camera camera, StandardView view);

}  // namespace burnish
