#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/model/documents/depth_choice.h"

namespace burnish {

/// Draws the depths as lines of an open list or menu, `current` marked. Those that do not fit are
/// disabled and say why. Returns the depth that the user chooses.
std::optional<int> draw_depth_list(const std::vector<DepthChoice>& choices, int current);

/// Returns the default depth of the choices. Needs: one of them is it.
int default_of(const std::vector<DepthChoice>& choices);

}  // namespace burnish
