#pragma once

#include <imgui.h>

#include "client/model/workspace/workspace.h"

namespace burnish {

/// Draws the scale bar of the picture. `lower_right`: of what is free for it. `pixels`: of the
/// framebuffer for a unit of the screen.
void draw_scale_bar_overlay(const Workspace& workspace, const ImVec2& lower_right,
                            const ImVec2& pixels);

/// Draws the scan's axes over the picture, whose upper left corner is at `at`.
void draw_axes_overlay(const Workspace& workspace, const ImVec2& at, const ImVec2& pixels);

}  // namespace burnish
