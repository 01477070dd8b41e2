#pragma once

#include "client/model/input/bindings.h"
#include "client/model/workspace/workspace.h"

namespace burnish {

/// Applies an action to the open session and its picture. Ignores actions of the window. Needs: a
/// document.
void do_document_action(Action action, Workspace& workspace);

}  // namespace burnish
