#include "client/model/document_actions.h"

namespace burnish {

void do_document_action(Action action, Workspace& workspace) {
  constexpr double kRadiusStep = 1.15;
  Document& document = *workspace.document();
  Viewport& viewport = workspace.viewport;
  switch (action) {
    case Action::kUndo:
      return document.undo();
    case Action::kRedo:
      return document.redo();
    case Action::kFrameAll:
      return viewport.frame_all(document);
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
    case Action::kWireframe:
      viewport.options.wireframe = !viewport.options.wireframe;
      return;
    case Action::kSplit:
      viewport.options.split = !viewport.options.split;
      return;
    case Action::kBookmark:
      return viewport.bookmarks.push_back(viewport.camera);
    case Action::kOpen:
    case Action::kExport:
    case Action::kScreenshot:
    case Action::kLog:
    case Action::kHelp:
    case Action::kCancel:
      return;
  }
}

}  // namespace burnish
