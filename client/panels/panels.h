#pragma once

#include "client/model/workspace/workspace.h"
#include "client/panels/widgets.h"

namespace burnish {

/// A panel that the window and the page have in common.
struct SharedPanel {
  const char* name;
  /// Shows its widgets, and does what the user does with them. Needs: an open document.
  void (*show)(Workspace& workspace, Widgets& widgets);
};

void show_brush(Workspace& workspace, Widgets& widgets);
void show_edges(Workspace& workspace, Widgets& widgets);
void show_colours(Workspace& workspace, Widgets& widgets);
void show_light(Workspace& workspace, Widgets& widgets);
void show_lighting(Lighting& lighting, Widgets& widgets);  ///< show_light() alone
void show_view(Workspace& workspace, Widgets& widgets);
void show_camera(Workspace& workspace, Widgets& widgets);
void show_limits(Workspace& workspace, Widgets& widgets);

/// The airbrush.
inline constexpr SharedPanel kBrushPanel = {"Brush", show_brush};
/// Takes noise away and keeps edges, before the filter smooths or sharpens.
inline constexpr SharedPanel kEdgesPanel = {"Keep edges", show_edges};
/// The filter of the scan's colours, and of their texture.
inline constexpr SharedPanel kColourPanel = {"Colours", show_colours};
/// How the surface is lit.
inline constexpr SharedPanel kLightPanel = {"Light", show_light};
/// How the surface is shown.
inline constexpr SharedPanel kViewPanel = {"View", show_view};
/// The point from which the surface is seen.
inline constexpr SharedPanel kCameraPanel = {"Camera", show_camera};
/// The bounds on what edits do, and the region in which nothing moves.
inline constexpr SharedPanel kLimitsPanel = {"Limits", show_limits};

inline constexpr SharedPanel kSharedPanels[] = {
    kBrushPanel, kEdgesPanel, kColourPanel, kLightPanel, kViewPanel, kCameraPanel, kLimitsPanel};

/// Lets the brush paint something else. `word`: as painted_word() gives it.
void paint_instead(const char* word, Workspace& workspace);

/// Previews an edit while its slider moves, and makes it when the slider is let go.
void follow(SliderChange change, Change edit, Document& document);

}  // namespace burnish
