#include "client/model/workspace/document_actions.h"

namespace burnish {

// The actions stand in the order of StandardView.
static StandardView standard_view_of(Action action) {
  return static_cast<StandardView>(static_cast<int>(action) - static_cast<int>(Action::kFront));
}

void do_document_action(Action action, Workspace& workspace) {
  constexpr double kRadiusStep = 1.15;
  constexpr double kTurnStep = 15;  // degrees
  Document& document = *workspace.document();
  Viewport& viewport = workspace.viewport;
  switch (action) {
    case Action::kUndo:
      return document.undo();
    case Action::kRedo:
      return document.redo();
    case Action::kFrameAll:
      return viewport.go_home();
    case Action::kFront:
    case Action::kBack:
    case Action::kRight:
    case Action::kLeft:
    case Action::kTop:
    case Action::kBottom:
      return viewport.show_from(standard_view_of(action));
    case Action::kOrthographic:
      viewport.camera.orthographic = !viewport.camera.orthographic;
      return;
    case Action::kTurnLeft:
      return viewport.turn(-kTurnStep, 0);
    case Action::kTurnRight:
      return viewport.turn(kTurnStep, 0);
    case Action::kTurnUp:
      return viewport.turn(0, kTurnStep);
    case Action::kTurnDown:
      return viewport.turn(0, -kTurnStep);
    case Action::kFocus:
      return viewport.focus();
    case Action::kBrushRadius:
      return viewport.begin_radius(document);
    case Action::kBrushStrength:
      return viewport.begin_strength(document);
    case Action::kRadiusDown:
      return document.brush().scale_radius(1 / kRadiusStep, document.diagonal());
    case Action::kRadiusUp:
      return document.brush().scale_radius(kRadiusStep, document.diagonal());
    case Action::kNavigateMode:
      viewport.navigate_mode = !viewport.navigate_mode;
      return;
    case Action::kMeasureMode:
      viewport.measure_mode = !viewport.measure_mode;
      return;
    case Action::kWireframe:
      viewport.options.wireframe = !viewport.options.wireframe;
      return;
    case Action::kSplit:
      viewport.options.split = !viewport.options.split;
      return;
    case Action::kBookmark:
      return viewport.add_bookmark();
    case Action::kOpen:
    case Action::kExport:
    case Action::kScreenshot:
    case Action::kLog:
    case Action::kHelp:
    case Action::kSave:
    case Action::kQuit:
    case Action::kCancel:
      return;
  }
}

}  // namespace burnish
