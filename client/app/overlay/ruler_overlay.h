#pragma once

#include <imgui.h>

#include "client/model/workspace/workspace.h"

namespace burnish {

/// Draws the ruler over the picture whose upper left corner is at `at`, in ImGui's units.
/// `pixels`: pixels of the picture per unit.
void draw_ruler_overlay(const Workspace& workspace, const ImVec2& at, const ImVec2& pixels);

}  // namespace burnish
